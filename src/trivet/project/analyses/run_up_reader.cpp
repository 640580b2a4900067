// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/wanted_reader.h"

namespace trivet::project {

OrdersRequest read_orders_request(TableReader& reader, const ResultNames& names, const Mentioned& mentioned) {
  OrdersRequest request;
  read_wanted(reader, names, mentioned.order_excitations, "order", request.wanted);
  if (!reader.has("speed")) reader.missing("speed", "give the range of shaft speeds: speed = [\"600 rpm\", \"3000 rpm\"]");
  request.speed = read_band(reader, "speed").value_or(response::Band{0, 1});
  return request;
}

}  // namespace trivet::project
