// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <utility>

#include "trivet/engine/command_rows.h"

namespace trivet::engine {

void set_forms(std::function<documents::Document(const project::DisplayUnits& display)> view,
               std::shared_ptr<const void> held, const project::DisplayUnits& own,
               const std::vector<std::string>& files, Result& result, const std::string& closing) {
  const auto document = [view = std::move(view), held](const project::DisplayUnits& display) {
    documents::Document found = view(display);
    found.held =
        std::make_shared<const std::pair<std::shared_ptr<const void>, std::shared_ptr<const void>>>(held, found.held);
    return found;
  };
  result.json = writer([document, own] { return documents::as_json_text(document(own)); });
  result.text_in = [document, closing](const project::DisplayUnits& display) {
    return documents::as_text(document(display), display) + closing;
  };
  result.text_on = [document, own, closing](const documents::Screen& screen) {
    return documents::as_text(document(own), own, screen) + closing;
  };
  result.text = writer([text = result.text_in, own] { return text(own); });
  result.html = [document](const project::DisplayUnits& display) {
    return documents::as_html(document(display), display);
  };
  for (const std::string& file : files)
    result.tables.emplace_back(file, writer([document, own, file] { return documents::as_csv(document(own), file); }));
  if (!files.empty())
    result.columns = [document](const std::string& file, const project::DisplayUnits& display) {
      return documents::as_columns(document(display), file, display);
    };
  result.arrays = [document, own] {
    documents::LabelledArrays arrays;
    documents::add_arrays(document(own), arrays);
    return arrays;
  };
  result.document = document;
  result.display = own;
  result.held = std::move(held);
}

}  // namespace trivet::engine
