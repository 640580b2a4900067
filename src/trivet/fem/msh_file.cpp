// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/msh_file.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <unordered_map>

#include "trivet/foundation/index.h"

namespace trivet::fem {
namespace {

using foundation::Problems;

constexpr int triangle_6 = 9, tetrahedron_10 = 11;  // gmsh's element type numbers

struct Malformed {};

/// Reads numbers and words of a text in sequence.
class Reader {
 public:
  explicit Reader(const std::string& text) : next_(text.data()), end_(text.data() + text.size()) {}

  void find(std::string_view section) {
    const std::string_view rest(next_, to_size(end_ - next_));
    const std::size_t place = rest.find(section);
    if (place == std::string_view::npos) throw Malformed{};
    next_ += place + section.size();
  }
  template <typename Number>
  Number number() {
    while (next_ != end_ && (*next_ == ' ' || *next_ == '\n' || *next_ == '\r' || *next_ == '\t')) ++next_;
    Number value{};
    const auto [after, error] = std::from_chars(next_, end_, value);
    if (error != std::errc()) throw Malformed{};
    next_ = after;
    return value;
  }
  std::size_t count() {
    const auto value = number<std::size_t>();
    if (value > to_size(end_ - next_)) throw Malformed{};  // less than one character each
    return value;
  }
  void skip_line() {
    while (next_ != end_ && *next_ != '\n') ++next_;
  }

 private:
  const char* next_;
  const char* end_;
};

/// Elements of one kind with the entity that they mesh.
struct ElementBlock {
  int size;
  std::vector<int> nodes, entity;
  [[nodiscard]] Eigen::MatrixXi matrix() const {
    return Eigen::Map<const Eigen::MatrixXi>(nodes.data(), size, to_index(entity.size()));
  }
};

MshFile parse(const std::string& text) {
  Reader reader(text);
  reader.find("$MeshFormat");
  if (reader.number<double>() != 2.2 || reader.number<int>() != 0) throw Malformed{};

  reader.find("$Nodes");
  MshFile mesh;
  mesh.nodes.resize(3, to_index(reader.count()));
  std::unordered_map<int, int> index;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i) {
    index[reader.number<int>()] = static_cast<int>(i);
    for (int k = 0; k < 3; ++k) mesh.nodes(k, i) = reader.number<double>();
  }

  reader.find("$Elements");
  ElementBlock triangles{6, {}, {}}, tetrahedra{10, {}, {}};
  for (std::size_t i = reader.count(); i > 0; --i) {
    reader.number<int>();  // its own number
    const int kind = reader.number<int>(), tags = reader.number<int>();
    ElementBlock* block = kind == triangle_6 ? &triangles : kind == tetrahedron_10 ? &tetrahedra : nullptr;
    if (!block || tags < 2) {
      reader.skip_line();
      continue;
    }
    reader.number<int>();  // physical group
    block->entity.push_back(reader.number<int>());
    for (int k = 2; k < tags; ++k) reader.number<int>();
    for (int k = 0; k < block->size; ++k) {
      const auto node = index.find(reader.number<int>());
      if (node == index.end()) throw Malformed{};
      block->nodes.push_back(node->second);
    }
  }
  mesh.triangles = triangles.matrix();
  mesh.face = triangles.entity;
  mesh.tetrahedra = tetrahedra.matrix();
  mesh.solid = tetrahedra.entity;
  return mesh;
}

}  // namespace

foundation::Expected<MshFile> read_msh(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  try {
    return parse(text);
  } catch (const Malformed&) {
    Problems problems;
    problems.error("mesh", fmt::format("{} of {} bytes is not a mesh", file.filename().string(), text.size()),
                   "it must be a text file in gmsh's format 2.2", "check whether the disk is full");
    return tl::unexpected(problems);
  }
}

}  // namespace trivet::fem
