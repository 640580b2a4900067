// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/preload_words.h"
#include "trivet/results/format/result_writer.h"

/// The load on each mount at rest.
namespace trivet::results {
namespace {

Table load_table(const study::CaseResults& results) {
  using response::MountLoad;
  const std::vector<MountLoad>& mounts = results.load_sharing->mounts;
  const Rows row(mounts);
  const auto deflection = [](int component) {
    return [component](const MountLoad& m) { return m.deflection(component); };
  };
  return {
      .key = "mounts",
      .axis = "element",
      .plain_names = true,
      .file = "load_sharing.csv",
      .title = "Load sharing along gravity",
      .rows = row.size(),
      .columns = {row("element", Kind::words, "mount", &MountLoad::element),
                  row.lists("force", "", "direction", {}, &MountLoad::force, {.unit = "N"}),
                  row("bearing", Kind::quantity, "load", &MountLoad::bearing, {.unit = "N"}),
                  row("share", Kind::share, "share", &MountLoad::share),
                  row.lists("deflection", "", "coordinate", {}, &MountLoad::deflection, {.unit = unit_of_the_row}),
                  row("x", Kind::quantity, "deflection x", deflection(0), {.unit = "m", .forms = in_csv | for_people}),
                  row("y", Kind::quantity, "y", deflection(1), {.unit = "m", .forms = in_csv | for_people}),
                  row("z", Kind::quantity, "z", deflection(2), {.unit = "m", .forms = in_csv | for_people})},
      .csv = {"element",
              {"bearing [N]", "bearing"},
              "share",
              {"deflection x [m]", "x"},
              {"deflection y [m]", "y"},
              {"deflection z [m]", "z"}},
      .mark = [&mounts](std::size_t i) { return mounts[i].bearing < 0 ? Mark::bad : Mark::plain; },
      .forms = for_programs | on_screen | on_page};
}

Sentence load_note(const project::Case& variant, const study::CaseResults& results) {
  return {.parts = {"In total ", Quantity{results.load_sharing->bearing_in_total, "N"},
                    "; a mount with a negative share pulls down. Deflections of end K relative to N in the element's "
                    "axes." +
                        preload_words(variant.system)},
          .place = Sentence::Place::note,
          .forms = on_screen | on_page};
}

Document load_sharing_document(const project::Case& variant, const study::CaseResults& results) {
  Document document;
  document.add(Words{.axis = "direction", .list = {"x", "y", "z"}});
  add_motion_coordinates(document);
  document.add(load_table(results));
  document.add(load_note(variant, results));
  document.add(Single{.name = "bearing_in_total",
                      .value = results.load_sharing->bearing_in_total,
                      .unit = "N",
                      .forms = in_json | in_arrays});
  return document;
}

}  // namespace

void add_load_sharing(const project::Case& variant, const study::CaseResults& results, Document& document) {
  if (!results.load_sharing) return;
  document.add(load_table(results)).forms = on_screen | in_summary;
  document.add(load_note(variant, results)).forms = on_screen | in_summary;
}

const ResultWriter load_sharing_results = {
    .has_result = [](const project::Case&,
                     const study::CaseResults& results) { return results.load_sharing.has_value(); },
    .document = load_sharing_document,
    .files = {"load_sharing.csv"}};

}  // namespace trivet::results
