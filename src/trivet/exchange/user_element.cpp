// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/user_element.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/exchange/matrix_entries.h"

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

}  // namespace trivet::exchange
