// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "trivet/foundation/interruption.h"

namespace trivet::foundation {

/// `wanted`, or as many as the machine has if that is 0.
[[nodiscard]] int thread_count(int wanted);

struct PieceOptions {
  std::size_t size = 1;        ///< of a piece; never derived from the threads, so that results do not depend on them
  int threads = 0;             ///< 0: as many as the machine has
  Progress progress = {};      ///< called on the calling thread alone
  std::string_view task = "";  ///< what it reports
};

/// Calls work(first, last) for all pieces [first, last) of [0, count), on several threads, each piece once, in any
/// order. Whoever writes only what belongs to its piece gives the same bytes for 1 or 16 threads. The first exception
/// stops the others and is thrown on.
void for_each_piece(std::size_t count, const PieceOptions& options,
                    const std::function<void(std::size_t first, std::size_t last)>& work);

}  // namespace trivet::foundation
