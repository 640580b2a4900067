// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_formats.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

namespace {

/// Collects the content of the lines, then assembles the matrix.
class UserElement {
 public:
  UserElement(std::string wanted, FileProblems& problems) : wanted_(std::move(wanted)), problems_(problems) {}

  void read_line(std::string_view line, int number) {
    line_ = number;
    const std::string_view text = trimmed(line);
    if (text.empty()) return;
    if (text.starts_with("**"))
      read_comment(trimmed(text.substr(
          text.find_first_not_of('*') == std::string_view::npos ? text.size() : text.find_first_not_of('*'))));
    else if (text.starts_with('*')) read_keyword(lower(text));
    else if (section_ == Section::components) read_components(text);
    else if (section_ == Section::values) read_values(text);
  }

  std::optional<NamedMatrix> matrix() {
    const std::vector<Label> labels = rows();
    const auto order = static_cast<long long>(labels.size());
    const long long wanted = unsymmetric_ ? order * order : order * (order + 1) / 2;
    check_size(order, order, line_, problems_);
    check_labels(labels, line_, problems_);
    if (problems_.any()) return std::nullopt;
    if (static_cast<long long>(values_.size()) != wanted) {
      std::string others;
      for (const std::string& type : types_) others += (others.empty() ? "the file has " : ", ") + type;
      problems_.error(line_, "*MATRIX, TYPE=" + wanted_, fmt::format("{} numbers", values_.size()),
                      fmt::format("{} components need {}", order, wanted),
                      values_.empty() ? (others.empty() ? "add the matrix to the output request" : others)
                                      : "was the file cut off?");
      return std::nullopt;
    }
    NamedMatrix result;
    result.values.resize(order, order);
    std::size_t next = 0;
    for (Eigen::Index i = 0; i < order; ++i)
      for (Eigen::Index j = 0; j < (unsymmetric_ ? order : i + 1); ++j) {
        result.values(i, j) = values_[next++];
        if (!unsymmetric_) result.values(j, i) = result.values(i, j);
      }
    result.labels = labels;
    if (nodes_.empty())
      problems_.warning(0, "nodes", "the file does not list them", "a comment ** ELEMENT NODES names them",
                        "they are numbered 1, 2, … in their order");
    result.warnings = problems_.all();
    return result;
  }

 private:
  enum class Section { none, components, values };

  void read_comment(std::string_view text) {
    const auto parts = cells(text, ',');
    const bool all_numbers =
        !parts.empty() && std::ranges::all_of(parts, [](std::string_view p) { return p.empty() || whole_number(p); });
    if (listing_nodes_ && all_numbers) {
      for (const std::string_view part : parts)
        if (!part.empty()) nodes_.push_back(*whole_number(part));
    } else {
      listing_nodes_ = lower(text) == "element nodes";
    }
  }

  void read_keyword(const std::string& text) {
    section_ = Section::none;
    listing_nodes_ = false;
    const auto parts = cells(text, ',');
    if (parts.front() == "*user element") {
      section_ = Section::components;
      for (const std::string_view part : parts) {
        if (part.starts_with("nodes"))
          count_ = whole_number(trimmed(part.substr(std::min(part.size(), part.find('=') + 1)))).value_or(0);
        if (part == "unsymm") unsymmetric_ = true;
      }
      if (elements_++ > 0)
        problems_.error(line_, "*USER ELEMENT", "a second one", "one element is read from a file",
                        "put each into a separate file");
    } else if (parts.front() == "*matrix") {
      for (const std::string_view part : parts) {
        if (!part.starts_with("type")) continue;
        const std::string type(trimmed(part.substr(std::min(part.size(), part.find('=') + 1))));
        types_.push_back(type);
        if (type == wanted_) section_ = Section::values;
      }
    }
  }

  /// The first line lists the components of the first node; a later line begins with the position of the node from
  /// which its list applies.
  void read_components(std::string_view text) {
    std::vector<int> numbers;
    for (const std::string_view part : cells(text, ',')) {
      if (part.empty()) continue;
      numbers.push_back(whole_number(part).value_or(0));
    }
    const int place = lists_.empty() ? 1 : numbers.empty() ? 0 : numbers.front();
    if (!lists_.empty() && !numbers.empty()) numbers.erase(numbers.begin());
    const bool known = std::ranges::all_of(numbers, [](int c) { return c >= 1 && c <= 6; });
    const bool rises = lists_.empty() || place > lists_.back().place;
    if (numbers.empty() || numbers.size() > 6 || !known || !rises)
      problems_.error(line_, "components", in_quotes(text),
                      "a line lists components 1 to 6, after the position of a node that increases from line to line",
                      "correct the line");
    else lists_.push_back({place, numbers});
  }

  void read_values(std::string_view text) {
    for (const std::string_view part : cells(text, ',')) {
      if (part.empty()) continue;
      const auto value = fortran_number(part);
      if (!value)
        problems_.error(line_, "entry", in_quotes(part), "every entry is a finite number", "correct the line");
      values_.push_back(value.value_or(0));
    }
  }

  std::vector<Label> rows() {
    std::vector<Label> labels;
    if (count_ < 1 || count_ > largest_order || lists_.empty()) {
      problems_.error(line_, "*USER ELEMENT", fmt::format("NODES={}, {} lists of components", count_, lists_.size()),
                      fmt::format("it has 1 to {} nodes and a list of components", largest_order),
                      "was the file cut off?");
    } else if (!nodes_.empty() && static_cast<int>(nodes_.size()) != count_) {
      problems_.error(line_, "nodes", fmt::format("{} in the comment", nodes_.size()), fmt::format("NODES={}", count_),
                      "correct the list of nodes");
    } else {
      std::size_t list = 0;
      for (int place = 1; place <= count_; ++place) {
        if (list + 1 < lists_.size() && lists_[list + 1].place == place) ++list;
        for (const int component : lists_[list].components)
          labels.push_back({nodes_.empty() ? place : nodes_[place - 1], component});
      }
    }
    return labels;
  }

  struct List {
    int place = 0;
    std::vector<int> components;
  };
  std::string wanted_;
  FileProblems& problems_;
  Section section_ = Section::none;
  bool listing_nodes_ = false, unsymmetric_ = false;
  int line_ = 0, count_ = 0, elements_ = 0;
  std::vector<int> nodes_;
  std::vector<List> lists_;
  std::vector<std::string> types_;
  std::vector<double> values_;
};

}  // namespace

foundation::Expected<NamedMatrix> read_user_element(std::string_view text, const std::string& type,
                                                    FileProblems& problems) {
  UserElement element(type, problems);
  for (Lines lines(text); !problems.enough() && lines.next();) element.read_line(lines.line(), lines.number());
  auto matrix = problems.any() ? std::nullopt : element.matrix();
  if (!matrix) return problems.refused();
  return std::move(*matrix);
}

namespace {

/// Numbers between commas or blanks.
std::vector<std::string_view> fields(std::string_view line) {
  return line.find(',') == std::string_view::npos ? blank_separated(line) : cells(line, ',');
}

std::optional<LabelledEntry> read_entry(std::string_view line, int number, FileProblems& problems) {
  auto parts = fields(line);
  if (!parts.empty() && parts.back().empty()) parts.pop_back();
  std::optional<int> place[4];
  for (std::size_t i = 0; i < 4 && i < parts.size(); ++i) place[i] = whole_number(parts[i]);
  const auto value = parts.size() == 5 ? fortran_number(parts[4]) : std::nullopt;
  if (!value || !place[0] || !place[1] || !place[2] || !place[3]) {
    problems.error(number, "entry", in_quotes(line),
                   "an entry is row node, row component, column node, column component, finite number",
                   "write it in Abaqus with FORMAT=MATRIX INPUT, which names the nodes");
    return std::nullopt;
  }
  for (const int i : {1, 3})
    if (*place[i] < 1 || *place[i] > 6) {
      problems.error(number, "component", std::to_string(*place[i]),
                     "components are 1 to 6 (translations, then rotations)",
                     "remove temperatures, pressures and warping from the model");
      return std::nullopt;
    }
  return LabelledEntry{{*place[0], *place[1]}, {*place[2], *place[3]}, {0, 0, *value, 0, number}};
}

foundation::Expected<NamedMatrix> read_matrix_input(std::string_view text, FileProblems& problems) {
  std::vector<LabelledEntry> entries;
  int last = 0;
  for (Lines lines(text); !problems.enough() && lines.next();) {
    if (trimmed(lines.line()).empty() || lines.line().starts_with('*')) continue;
    last = lines.number();
    if (const auto entry = read_entry(lines.line(), last, problems)) entries.push_back(*entry);
  }
  if (problems.any()) return problems.refused();
  auto matrix = assembled(entries, std::nullopt, false, last, problems);
  if (!matrix) return problems.refused();
  return std::move(*matrix);
}

bool has_user_element(std::string_view text) {
  for (Lines lines(text); lines.next();)
    if (lower(lines.line().substr(0, 5)) == "*user") return true;
  return false;
}

}  // namespace

foundation::Expected<NamedMatrix> read_abaqus_matrix(std::string_view text, const std::string& source,
                                                     const std::string& type) {
  FileProblems problems(source);
  return has_user_element(text) ? read_user_element(text, lower(type), problems) : read_matrix_input(text, problems);
}

}  // namespace trivet::exchange
