// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/part_readers.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/elements/catalogue.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

constexpr std::string_view prefix = "catalogue:";
constexpr const char* path_example = "path = ['elements.\"front left\".type', 'elements.\"front right\".type']";

/// Catalogues of a choice, the first one first.
struct Shelf {
  std::vector<Catalogue> catalogues;
  bool readable = true;
};

class ChoiceReader {
 public:
  ChoiceReader(const Node& table, const std::string& name, TableReader& root, const Node& written)
      : reader_(table, "parameters." + name, root.problems()), written_(written) {
    choice_.name = name;
  }

  MountChoice read() {
    read_places();
    const Shelf shelf = read_shelf();
    if (reader_.has("choices")) read_named(shelf);
    else if (shelf.readable)
      for (const Mount& mount : shelf.catalogues.front().mounts) choice_.mounts.push_back(mount.name);
    reader_.finish();
    return std::move(choice_);
  }

 private:
  void read_places() {
    if (!reader_.has("path")) reader_.missing("path", path_example);
    const auto paths = reader_.texts("path", path_example);
    if (!paths) return;
    if (paths->empty()) reader_.error("path", "no path", "a choice has at least one place", path_example);
    for (const std::string& path : *paths)
      if (is_place(path)) {
        choice_.paths.push_back(path);
        add_elements_at(path_keys(path));
      }
  }

  void add_elements_at(const std::vector<std::string>& keys) {
    if (keys[0] == "elements") return choice_.elements.push_back(keys[1]);
    const Node* elements = written_.find("elements");
    for (std::size_t i = 0; elements && i < elements->keys.size(); ++i) {
      const Node* type = elements->items[i].find("type");
      if (type && type->text == keys[1]) choice_.elements.push_back(elements->keys[i]);
    }
  }

  /// A place has a mount of a catalogue, which others replace.
  bool is_place(const std::string& path) {
    const std::vector<std::string> keys = path_keys(path);
    const std::string shown = foundation::quoted(path);
    constexpr std::size_t part_and_key = 3;
    if (keys.size() != part_and_key || (keys[0] != "elements" && keys[0] != "element_types") || keys[2] != "type")
      return refuse(shown, "a choice of mounts is the type of elements", path_example);
    const Node* table = written_.find(keys[0]);
    if (!table || !table->find(keys[1])) {
      const std::string guess = table ? foundation::nearest_name(keys[1], table->keys) : "";
      return refuse(shown, fmt::format("the file has no {} there", foundation::quoted(keys[1])),
                    guess.empty() ? "check the path" : "did you mean " + foundation::quoted(guess) + "?");
    }
    const Node* type = node_at(written_, keys);
    if (!type || type->kind != Node::Kind::text || !type->text.starts_with(prefix))
      return refuse(shown,
                    fmt::format("its type is {}, no mount of a catalogue", type ? value_text(*type) : "not given"),
                    "give it a mount first: type = \"catalogue:NAME\"; the choice replaces it. If elements share "
                    "[element_types.NAME], the path is element_types.NAME.type");
    if (std::ranges::find(choice_.paths, path) != choice_.paths.end())
      return refuse(shown, "the choice names this place twice", "name it once");
    return true;
  }

  bool refuse(const std::string& finding, const std::string& rule, const std::string& remedy) {
    reader_.error("path", finding, rule, remedy);
    return false;
  }

  /// The catalogue of a place, if it names one.
  [[nodiscard]] const Node* own_catalogue(const std::string& path) const {
    std::vector<std::string> keys = path_keys(path);
    keys.back() = "catalogue";
    return node_at(written_, keys);
  }

  Shelf read_shelf() {
    Shelf shelf;
    const Node* of_choice = reader_.node("catalogue");
    const bool generic = of_choice && of_choice->kind == Node::Kind::text && of_choice->text == "generic";
    if (generic) {
      for (const std::string& path : choice_.paths)
        if (own_catalogue(path)) {
          reader_.error("catalogue", "\"generic\"",
                        fmt::format("{} has a catalogue of its own", foundation::quoted(path)),
                        "name that catalogue, or list choices");
          shelf.readable = false;
        }
    } else if (of_choice) {
      choice_.catalogue = *of_choice;
      add(shelf, reader_, "catalogue");
    } else if (!choice_.paths.empty() && own_catalogue(choice_.paths.front())) {
      const std::vector<std::string> keys = path_keys(choice_.paths.front());
      foundation::Problems reported_with_the_element;
      TableReader place(*node_at(written_, {keys[0], keys[1]}), "", reported_with_the_element);
      add(shelf, place, "catalogue");
    }
    shelf.catalogues.push_back(generic_catalogue());
    return shelf;
  }

  static void add(Shelf& shelf, TableReader& reader, const std::string& key) {
    const auto file = read_file_name(reader, key);
    auto read = file ? read_catalogue(*file) : foundation::Expected<Catalogue>(Catalogue());
    shelf.readable = file && read;
    if (!read) reader.add_of_file(key, read.error());
    else if (file) shelf.catalogues.push_back(std::move(*read));
  }

  void read_named(const Shelf& shelf) {
    const char* example = R"(choices = ["catalogue:disc 50x25 40 ShA", "catalogue:disc 50x25 55 ShA"])";
    const auto words = reader_.texts("choices", example);
    if (!words) return;
    if (words->empty()) reader_.error("choices", "an empty list", "a choice has at least one mount", example);
    for (const std::string& word : *words) {
      const std::string shown = foundation::quoted(word);
      if (!word.starts_with(prefix)) {
        reader_.error("choices", shown, "a choice is a mount of a catalogue", example);
        continue;
      }
      const std::string name = word.substr(prefix.size());
      if (std::ranges::find(choice_.mounts, name) != choice_.mounts.end())
        reader_.error("choices", shown, "it is named twice", "name it once");
      if (shelf.readable)
        if (const auto found = mount_named(name, shelf.catalogues); !found) {
          const foundation::Problem& problem = foundation::error_of(found.error());
          reader_.error("choices", shown, problem.rule, problem.remedy);
        }
      choice_.mounts.push_back(name);
    }
  }

  TableReader reader_;
  const Node& written_;
  MountChoice choice_;
};

/// Reports places of two choices.
void refuse_shared_places(const std::vector<MountChoice>& choices, TableReader& root) {
  for (std::size_t i = 0; i < choices.size(); ++i)
    for (const std::string& path : choices[i].paths)
      for (std::size_t j = 0; j < i; ++j) {
        const bool same = std::ranges::any_of(
            choices[j].paths, [&](const std::string& other) { return path_keys(other) == path_keys(path); });
        if (!same) continue;
        root.problems()
            .error("parameters." + choices[i].name + ".path", foundation::quoted(path),
                   "the choice " + foundation::quoted(choices[j].name) + " sets this mount too",
                   "a place has one choice: remove it from one of them")
            .origin = deepest(*root.node("parameters"), foundation::path_key(choices[i].name) + ".path").origin;
      }
}

/// Adds "path = text".
void set_text(Node& change, const std::vector<std::string>& keys, const Node& text) {
  Node* at = &change;
  for (const std::string& key : keys) {
    Node* next = at->find(key);
    if (!next) {
      at->keys.push_back(key);
      next = &at->items.emplace_back();
    }
    at = next;
  }
  *at = text;
}

}  // namespace

std::vector<MountChoice> read_mount_choices(TableReader& root, const Node& written) {
  std::vector<MountChoice> choices;
  const Node* table = root.has("parameters") ? root.node("parameters") : nullptr;
  if (!table || table->kind != Node::Kind::table) return choices;
  for (std::size_t i = 0; i < table->keys.size(); ++i)
    if (is_mount_choice(table->items[i]))
      choices.push_back(ChoiceReader(table->items[i], table->keys[i], root, written).read());
  refuse_shared_places(choices, root);
  return choices;
}

Node change_of(const MountChoice& choice, std::size_t mount) {
  Node change, type;
  type.kind = Node::Kind::text;
  type.text = std::string(prefix) + choice.mounts[mount];
  for (const std::string& path : choice.paths) {
    std::vector<std::string> keys = path_keys(path);
    set_text(change, keys, type);
    keys.back() = "catalogue";
    if (choice.catalogue) set_text(change, keys, *choice.catalogue);
  }
  return change;
}

}  // namespace trivet::project
