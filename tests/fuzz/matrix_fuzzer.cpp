// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: any bytes as a matrix file of any format; a matrix that is read is then condensed.
#include <cstddef>
#include <cstdint>
#include <string>

#include "trivet/exchange/end_stiffness.h"
#include "trivet/exchange/matrix_formats.h"
#include "trivet/exchange/named_matrix.h"

namespace {

void use(const trivet::foundation::Expected<trivet::exchange::NamedMatrix>& matrix) {
  if (!matrix || matrix->values.rows() > 60) return;
  static_cast<void>(trivet::exchange::reduce_to_rows(*matrix, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  if (!matrix->labels.empty())
    static_cast<void>(trivet::exchange::reduce_to_ends(*matrix, trivet::exchange::NodeEnd{matrix->labels.front().node},
                                                       trivet::exchange::NodeEnd{matrix->labels.back().node}));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  use(trivet::exchange::read_matrix_market(text, "fuzz"));
  use(trivet::exchange::read_numpy_array(text, "fuzz"));
  use(trivet::exchange::read_csv_matrix(text, "fuzz"));
  use(trivet::exchange::read_nastran_dmig(text, "fuzz"));
  use(trivet::exchange::read_abaqus_matrix(text, "fuzz"));
  use(trivet::exchange::read_matrix_storage(text, "fuzz", text, "fuzz"));
  return 0;
}
