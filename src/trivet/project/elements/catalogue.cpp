// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/load_ranges.h"
#include "trivet/project/text/embedded_text.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/table_reader.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_mounts = 10000;
constexpr std::size_t longest_mount_name = 100;
/// Rounding of the numbers in a data sheet.
constexpr double data_sheet_rounding = 0.05;

/// Three stiffnesses, none negative.
Eigen::Vector3d stiffness(TableReader& reader, const std::string& key, Quantity quantity) {
  const auto values = reader.vector(key, quantity);
  if (values && values->minCoeff() < 0)
    reader.error(key, fmt::format("{:.6g} {}", values->minCoeff(), si_unit(quantity)), "a stiffness is ≥ 0",
                 "remove the sign");
  return values.value_or(Eigen::Vector3d::Zero());
}

std::optional<double> at_least_zero(TableReader& reader, const std::string& key, Quantity quantity) {
  const auto value = reader.number(key, quantity);
  if (value && *value < 0)
    reader.error(key, fmt::format("{:.6g} {}", *value, si_unit(quantity)), "it must be ≥ 0", "remove the sign");
  return value;
}

/// A limit of a deflection along the axis.
std::optional<double> deflection_limit(TableReader& reader, const std::string& key) {
  const auto limit = reader.number(key, Quantity::length);
  if (limit && !(*limit > 0))
    reader.error(key, fmt::format("{:.6g} m", *limit), "it must be > 0", "remove it if there is no limit");
  return limit;
}

double read_creep(TableReader& reader) {
  const auto creep = reader.number("creep", Quantity::pure);
  if (creep && !(*creep >= 1))
    reader.error("creep", fmt::format("{:.6g}", *creep), "static deflection after years over that at once is ≥ 1",
                 "for instance creep = 1.2");
  return creep.value_or(1);
}

std::optional<double> read_height(TableReader& reader) {
  const auto height = reader.number("height", Quantity::length);
  if (height && !(*height > 0))
    reader.error("height", fmt::format("{:.6g} m", *height), "the height of the unloaded mount is > 0",
                 "for instance height = \"31 mm\"");
  return height;
}

std::optional<model::Price> read_price_of_mount(TableReader& reader) {
  const auto text = reader.text("price");
  if (!text) return std::nullopt;
  auto price = price_from(*text);
  if (!price)
    reader.error("price", foundation::quoted(*text),
                 "a price is a number ≥ 0 and a currency, with a blank between them and a decimal point",
                 "for instance price = \"12.50 EUR\"; remove it if it is not known");
  return price;
}

/// What the maker allows, mass and price.
model::Rating read_rating(TableReader& reader, const std::string& name) {
  model::Rating rating;
  rating.mount = name;
  rating.load = read_load_ranges(reader);
  rating.deflection = deflection_limit(reader, "static_deflection_limit");
  rating.dynamic_deflection = deflection_limit(reader, "dynamic_deflection_limit");
  rating.shock_deflection = deflection_limit(reader, "shock_deflection_limit");
  rating.mass = at_least_zero(reader, "mass", Quantity::mass);
  rating.price = read_price_of_mount(reader);
  return rating;
}

/// Warns of values that are possible but do not agree.
void warn_of_slips(const Mount& mount, TableReader& reader) {
  const auto warn = [&](const std::string& key, std::string finding, std::string rule, std::string remedy) {
    reader.problems()
        .warning(reader.path() + "." + key, std::move(finding), std::move(rule), std::move(remedy))
        .origin = reader.node(key)->origin;
  };
  if (mount.loss_factor.value_or(0) > 1)
    warn("loss_factor", fmt::format("{:.6g}", *mount.loss_factor), "loss factors of rubber and metal are below 1",
         fmt::format("write \"{:.6g} %\" if percent are meant", *mount.loss_factor));
  const auto& along_axis = mount.rating.load[2];
  if (!along_axis || !(mount.rating.deflection.value_or(0) > 0) || mount.translation.z() == 0) return;
  const double deflection = along_axis->y() / mount.translation.z();
  if (deflection > (1 + data_sheet_rounding) * *mount.rating.deflection)
    warn(reader.has("static_load") ? "static_load" : "load",
         fmt::format("the highest load deflects the mount by {}", foundation::prefixed(deflection, "m")),
         fmt::format("its limit is {}", foundation::prefixed(*mount.rating.deflection, "m")),
         "check the units; a mount that stiffens is stiffer at this load than given here");
}

Mount read_mount(const Node& table, const std::string& name, const std::string& source,
                 foundation::Problems& problems) {
  TableReader reader(table, "mounts." + name, problems);
  Mount mount;
  mount.name = name;
  mount.origin = table.origin;
  mount.maker = reader.required_text("maker");
  if (!reader.has("translation"))
    reader.missing("translation",
                   "give three constants along x, y, z: translation = [\"60 N/mm\", \"60 N/mm\", \"350 N/mm\"]");
  mount.translation = stiffness(reader, "translation", Quantity::force_per_length);
  mount.rotation = stiffness(reader, "rotation", Quantity::moment_per_angle);
  mount.loss_factor = at_least_zero(reader, "loss_factor", Quantity::pure);
  mount.stiffening = stiffening_of(reader);
  mount.rating = read_rating(reader, name);
  mount.creep = read_creep(reader);
  mount.temperature = read_temperature(reader);
  mount.height = read_height(reader);
  mount.source = reader.text("source").value_or(source);
  warn_of_slips(mount, reader);
  reader.finish();
  return mount;
}

void read_mounts(TableReader& root, const std::string& source, Catalogue& catalogue) {
  if (!root.has("mounts")) root.missing("mounts", "write [mounts.\"NAME\"] and its data below");
  const Node* table = root.table("mounts");
  if (!table) return;
  if (table->keys.empty())
    root.error("mounts", "no mount", "a catalogue has at least one", "write [mounts.\"NAME\"] and its data below");
  if (table->keys.size() > most_mounts)
    root.error("mounts", fmt::format("{} mounts", table->keys.size()),
               fmt::format("a catalogue holds at most {}", most_mounts), "split it");
  for (std::size_t i = 0; i < table->keys.size() && i < most_mounts; ++i) {
    const std::string& name = table->keys[i];
    const bool good_name = !name.empty() && name.size() <= longest_mount_name &&
        std::ranges::none_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
    if (!good_name || table->items[i].kind != Node::Kind::table)
      root.problems()
          .error("mounts." + foundation::shortened(name), good_name ? kind_name(table->items[i].kind) : "not a name",
                 fmt::format("a mount is a table with a name of at most {} characters on one line", longest_mount_name),
                 "write [mounts.\"NAME\"] and its data below")
          .origin = table->items[i].origin;
    else catalogue.mounts.push_back(read_mount(table->items[i], name, source, root.problems()));
  }
}

/// Catalogues by file and text. Every mount of every changed design names its catalogue; to parse it each time took
/// half of `trivet select`.
class ParsedCatalogues {
 public:
  std::shared_ptr<const Catalogue> find(const std::string& file, const std::string& text) {
    const std::lock_guard lock(adding_);
    for (const auto& [of_text, catalogue] : list_)
      if (catalogue->file == file && of_text == text) return catalogue;
    return nullptr;
  }

  void add(const std::string& text, const Catalogue& catalogue) {
    const std::lock_guard lock(adding_);
    if (list_.size() >= most_) list_.erase(list_.begin());
    list_.emplace_back(text, std::make_shared<const Catalogue>(catalogue));
  }

 private:
  static constexpr std::size_t most_ = 8;
  std::mutex adding_;
  std::vector<std::pair<std::string, std::shared_ptr<const Catalogue>>> list_;
};

}  // namespace

const Mount* Catalogue::find(const std::string& name) const {
  const auto found = std::ranges::find(mounts, name, &Mount::name);
  return found == mounts.end() ? nullptr : &*found;
}

foundation::Expected<Catalogue> catalogue_from_text(const std::string& text, const std::string& file) {
  const foundation::Expected<Node> document = parse_toml(text, file);
  if (!document) return tl::make_unexpected(document.error());
  Catalogue catalogue;
  catalogue.file = file;
  TableReader root(*document, "", catalogue.warnings);
  if (!root.has("catalogue")) root.missing("catalogue", "start the file with catalogue = 1");
  const auto version = root.number("catalogue", Quantity::pure);
  if (version && *version != 1)
    root.error("catalogue", fmt::format("format {:.6g}", *version), "this program reads format 1",
               "write catalogue = 1, or use a newer program");
  catalogue.title = root.text("title").value_or("");
  read_mounts(root, root.text("source").value_or(""), catalogue);
  root.finish();
  catalogue.warnings.sort_by_origin();
  if (catalogue.warnings.has_errors()) return tl::make_unexpected(std::move(catalogue.warnings));
  return catalogue;
}

foundation::Expected<Catalogue> read_catalogue(const std::filesystem::path& path) {
  const auto text = read_source(path, "catalogue");
  if (!text) return tl::make_unexpected(text.error());
  static ParsedCatalogues parsed;
  if (const auto known = parsed.find(path.string(), *text)) return *known;
  auto catalogue = catalogue_from_text(*text, path.string());
  if (catalogue) parsed.add(*text, *catalogue);
  return catalogue;
}

const Catalogue& generic_catalogue() {
  static const Catalogue catalogue = [] {
    auto read = catalogue_from_text(generic_catalogue_text(), "generic.toml");
    if (!read) throw std::logic_error(message(read.error().list().front()));
    return std::move(*read);
  }();
  return catalogue;
}

foundation::Expected<Mount> mount_named(const std::string& name, const std::vector<Catalogue>& catalogues) {
  std::vector<std::string> names;
  for (const Catalogue& catalogue : catalogues) {
    if (const Mount* mount = catalogue.find(name)) return *mount;
    for (const Mount& mount : catalogue.mounts) names.push_back(mount.name);
  }
  const std::string near = foundation::nearest_name(name, names);
  foundation::Problems problems;
  problems.error("catalogue", foundation::quoted(name),
                 fmt::format("none of the {} mounts has this name", names.size()),
                 near.empty() ? "see the names in the catalogue" : "did you mean \"" + near + "\"?");
  return tl::make_unexpected(std::move(problems));
}

}  // namespace trivet::project
