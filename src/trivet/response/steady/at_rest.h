// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::response {

/// The machine that resists loads at rest. The position of rest of a machine with laws is that of the first order, and
/// so are its static results.
[[nodiscard]] const assembly::Assembled& of_statics(const model::System& system, const assembly::Assembled& assembled);

/// A machine as every static result sees it: with the static stiffness of its rubber, assembled again only if it has
/// one.
class AtRest {
 public:
  /// @param system, assembled  of vibration; used by the result
  AtRest(const model::System& system, const assembly::Assembled& assembled);

  [[nodiscard]] const model::System& system() const { return own_ ? own_->system : system_; }
  [[nodiscard]] const assembly::Assembled& assembled() const { return own_ ? own_->assembled : assembled_; }

 private:
  struct Own {
    model::System system;
    assembly::Assembled assembled;
  };
  const model::System& system_;
  const assembly::Assembled& assembled_;  ///< or what it has of the first order
  std::unique_ptr<const Own> own_;
};

/// Elements with end N on the ground or on a flexible foundation; the impedance of a ground point is not a mount.
[[nodiscard]] std::vector<std::size_t> mounts(const model::System& system);

}  // namespace trivet::response
