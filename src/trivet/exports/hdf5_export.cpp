// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>

#include "trivet/exports/format_table.h"
#include "trivet/exports/unique_names.h"
#include "trivet/project/input_files.h"
#include "trivet/project/text/document.h"

/// HDF5: a group for each result, a dataset for each array, dimension scales with the names of the axes, the attribute
/// `units`, and complex numbers as {r, i}, which h5py reads as complex.
namespace trivet::exports {
namespace {

using results::LabelledArray;

/// An identifier of the library, closed at the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 cannot make the file: not enough memory");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: the library takes identifiers

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status) {
  if (status < 0) throw std::runtime_error("HDF5 cannot make the file: not enough memory");
}

hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

hid_t complex_type() {
  const hid_t type = H5Tcreate(H5T_COMPOUND, 2 * sizeof(double));
  H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "i", sizeof(double), H5T_NATIVE_DOUBLE);
  return type;
}

void add_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type(text_type(), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const char* const words = text.c_str();
  require(H5Awrite(attribute, type, static_cast<const void*>(&words)));
}

hid_t space_of(const std::vector<std::size_t>& shape) {
  const std::vector<hsize_t> sizes(shape.begin(), shape.end());
  return shape.empty() ? H5Screate(H5S_SCALAR)
                       : H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
}

hid_t written_set(hid_t group, const std::string& name, const std::vector<std::size_t>& shape, hid_t type,
                  const void* data) {
  const Handle space(space_of(shape), H5Sclose);
  const hid_t set = H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (set < 0 || H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
    if (set >= 0) H5Dclose(set);
    return -1;
  }
  return set;
}

hid_t dataset(hid_t group, const std::string& name, const LabelledArray& array) {
  if (array.is_text()) {
    const Handle type(text_type(), H5Tclose);
    std::vector<const char*> words;
    for (const std::string& text : array.texts()) words.push_back(text.c_str());
    return written_set(group, name, array.shape, type, static_cast<const void*>(words.data()));
  }
  if (array.is_complex()) {
    const Handle type(complex_type(), H5Tclose);
    return written_set(group, name, array.shape, type, array.complex_numbers().data());
  }
  return written_set(group, name, array.shape, H5T_NATIVE_DOUBLE, array.real_numbers().data());
}

/// The names of a group in HDF5, which cannot have a slash.
class LinkNames {
 public:
  explicit LinkNames(std::vector<std::string>& lost) : lost_(lost) {}

  std::string operator()(const std::string& name) {
    const auto [known, is_new] = links_.emplace(name, "");
    if (!is_new) return known->second;
    std::string link = name;
    std::ranges::replace(link, '/', '_');
    known->second = used_.unique(link);
    if (known->second != name)
      lost_.push_back(fmt::format("\"{}\" is named \"{}\": names of HDF5 have no slash", name, known->second));
    return known->second;
  }

 private:
  std::vector<std::string>& lost_;
  UniqueNames used_;
  std::map<std::string, std::string> links_;
};

bool is_coordinate(const LabelledArray& array) { return array.axes.size() == 1 && array.axes[0] == array.name; }

/// A scale for an axis without coordinates: 1, 2, …
void add_count(hid_t group, const std::string& axis, std::size_t size) {
  std::vector<double> numbers(size);
  std::iota(numbers.begin(), numbers.end(), 1.0);
  const Handle set(written_set(group, axis, {size}, H5T_NATIVE_DOUBLE, numbers.data()), H5Dclose);
  require(H5DSset_scale(set, axis.c_str()));
  add_attribute(set, "units", "1");
}

void write_group(hid_t file, const Group& content, std::vector<std::string>& lost) {
  const Handle group(H5Gcreate2(file, content.name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  LinkNames link_name(lost);
  for (const LabelledArray& array : content.arrays.list())
    if (array.name.find('/') == std::string::npos) link_name(array.name);  // these keep their names
  std::map<std::string, std::size_t> axes;
  std::set<std::string> with_coordinates;
  for (const LabelledArray& array : content.arrays.list()) {
    for (std::size_t i = 0; i < array.axes.size(); ++i) axes[array.axes[i]] = array.shape[i];
    if (is_coordinate(array)) with_coordinates.insert(array.name);
  }
  for (const auto& [axis, size] : axes)
    if (!with_coordinates.count(axis)) add_count(group, link_name(axis), size);
  for (const bool coordinates : {true, false})
    for (const LabelledArray& array : content.arrays.list()) {
      if (is_coordinate(array) != coordinates) continue;
      const std::string name = link_name(array.name);
      const Handle set(dataset(group, name, array), H5Dclose);
      if (!array.unit.empty()) add_attribute(set, "units", array.unit);
      if (name != array.name) add_attribute(set, "long_name", array.name);
      if (coordinates) require(H5DSset_scale(set, name.c_str()));
      for (std::size_t i = 0; !coordinates && i < array.axes.size(); ++i) {
        const Handle scale(H5Dopen2(group, link_name(array.axes[i]).c_str(), H5P_DEFAULT), H5Dclose);
        require(H5DSattach_scale(set, scale, static_cast<unsigned>(i)));
      }
    }
}

/// The whole file. On disk, the library would crash at the end of the program if the disk was full.
std::string file_in_memory(const Content& content, std::vector<std::string>& lost) {
  constexpr std::size_t step = 1 << 20;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access, step, 0));
  const Handle file(H5Fcreate("export", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  add_attribute(file, "source", content.words());
  add_attribute(file, "sha256", project::input_hash(content.project));
  add_attribute(file, "title", content.project.title);
  std::string input;
  for (const std::string& setting : project::setting_words({content.variant.written})) input += setting + "\n";
  add_attribute(file, "input", input);
  for (const Group& group : content.groups) write_group(file, group, lost);
  require(H5Fflush(file, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) require(-1);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, bytes.data(), bytes.size()) < 0) require(-1);
  return bytes;
}

std::vector<std::string> write_hdf5(const Content& content, const Target& target, const foundation::Progress&) {
  static std::mutex one_at_a_time;  // the library is not made for threads
  const std::lock_guard lock(one_at_a_time);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors become exceptions, not text on the screen
  std::vector<std::string> lost;
  const std::string bytes = file_in_memory(content, lost);
  write_bytes(target.path(), bytes);
  return lost;
}

}  // namespace

const Format hdf5_format = {
    "hdf5",    "HDF5: every array with its axes and units; h5py, xarray, MATLAB", Target::Kind::file, {}, false,
    write_hdf5};

}  // namespace trivet::exports
