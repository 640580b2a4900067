// SPDX-License-Identifier: BSD-3-Clause
// The headers that nearly every file includes, compiled once: only the standard library, Eigen's core and formatting.
// No file may rely on it (tests/headers, tests/architecture); it only saves minutes of build time.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <tl/expected.hpp>
