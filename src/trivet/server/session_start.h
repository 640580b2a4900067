// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "trivet/foundation/temporary_folder.h"

namespace trivet::server {

/// 32 bytes of the system's random source, hexadecimal. @throws std::system_error
[[nodiscard]] std::string new_token();

/// A file for this user only that leads a browser to an address, so that the token in the address is in no list of
/// processes. Removed with the object, or when the process ends.
class RedirectFile {
 public:
  /// @throws std::runtime_error with the reason
  explicit RedirectFile(const std::string& address);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  foundation::TemporaryFolder folder_;
  std::string path_;
};

}  // namespace trivet::server
