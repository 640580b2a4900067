// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "trivet/assembly/assembled.h"

namespace trivet::response {

/// A linear machine as every static result sees it: with the static stiffness of its rubber, assembled again only if it
/// has one, and without the second-order effect of its weight.
class AtRest {
 public:
  /// @param system, assembled  of vibration; used by the result
  AtRest(const model::System& system, const assembly::Assembled& assembled);

  [[nodiscard]] const model::System& system() const { return own_ ? own_->system : system_; }
  [[nodiscard]] const assembly::Assembled& assembled() const {
    return (own_ ? own_->assembled : assembled_).first_order();
  }

 private:
  struct Own {
    model::System system;
    assembly::Assembled assembled;
  };
  const model::System& system_;
  const assembly::Assembled& assembled_;
  std::unique_ptr<const Own> own_;
};

}  // namespace trivet::response
