// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/project/text/document.h"
#include "trivet/project/text/level.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

/// Reads one table of a project file key by key; adds every problem to the list and continues. A key that no call reads
/// is unknown; `finish` reports it.
class TableReader {
 public:
  TableReader(const Node& table, std::string path, foundation::Problems& problems);

  /// Is there such a key? The message about an unknown key names it, too.
  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] const Node& content() const { return table_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] foundation::Problems& problems() const { return problems_; }

  /// The node of a key, or null; the key counts as known.
  const Node* node(const std::string& key);
  /// The table of a key, or null; another kind of value is a problem.
  const Node* table(const std::string& key);

  /// Marks keys as known, even if reading ends before it reaches them.
  void also_known(std::initializer_list<const char*> keys);
  /// Errors found so far, here and elsewhere; warnings do not count.
  [[nodiscard]] std::size_t errors() const;

  /// Name of a value in a check, and the key of the file for it.
  using Names = std::vector<std::pair<const char*, const char*>>;
  /// Adds findings of a check whose subjects are keys of this table, except for keys that could not be read.
  void add(const foundation::Problems& findings, const Names& names = {});
  /// Adds problems of the file that a key names; they keep their place in that file.
  void add_of_file(const std::string& key, const foundation::Problems& findings);

  /// @param levels  which may follow the unit; the result is at the level that the program has
  std::optional<double> number(const std::string& key, Quantity quantity, Levels levels = Levels::none);
  double required_number(const std::string& key, Quantity quantity, Levels levels = Levels::none);
  std::optional<std::string> text(const std::string& key);
  std::string required_text(const std::string& key);
  std::optional<bool> boolean(const std::string& key);
  /// One text or several. @param example  a value for the message
  std::optional<std::vector<std::string>> texts(const std::string& key, const std::string& example);
  std::optional<Eigen::Vector3d> vector(const std::string& key, Quantity quantity, Levels levels = Levels::none);
  std::optional<std::vector<double>> numbers(const std::string& key, Quantity quantity, Levels levels = Levels::none);
  /// Square matrix; `quantity_of(size, i, j)` is the quantity of each entry.
  std::optional<Eigen::MatrixXd> matrix(const std::string& key,
                                        const std::function<Quantity(int, int, int)>& quantity_of,
                                        const std::vector<int>& allowed_sizes);
  /// A direction: "x", "-z" or three numbers; unit vector.
  std::optional<Eigen::Vector3d> direction(const std::string& key);
  /// Local axes as columns, from {axis, angle} or {matrix}.
  std::optional<Eigen::Matrix3d> orientation(const std::string& key);
  /// One of the given words.
  std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& words);

  void missing(const std::string& key, const std::string& remedy);
  /// Adds an error at a key; an empty key means the table itself.
  foundation::Problem& error(const std::string& key, std::string finding, std::string rule, std::string remedy);
  /// Reports keys that no call has read.
  void finish();

  /// One number or text with a unit, and perhaps a level.
  std::optional<double> scalar(const Node& value, const std::string& where, Quantity quantity,
                               Levels levels = Levels::none);

 private:
  foundation::Problem& error_at(const Node& node, const std::string& where, std::string finding, std::string rule,
                                std::string remedy);

  const Node& table_;
  std::string path_;
  foundation::Problems& problems_;
  std::vector<std::string> known_;
  mutable std::vector<std::string> queried_;  ///< those of `has`, for messages: some are read only where they are given
};

}  // namespace trivet::project
