// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/student_distribution.h"

#include <boost/math/distributions/students_t.hpp>
#include <string>

#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {
namespace {

namespace policies = boost::math::policies;
/// Plain double arithmetic, equal on all processors, and no exceptions of Boost: a quantile above the largest double is
/// infinite.
using PlainPolicy = policies::policy<policies::promote_double<false>, policies::domain_error<policies::ignore_error>,
                                     policies::overflow_error<policies::ignore_error>,
                                     policies::evaluation_error<policies::ignore_error>>;

}  // namespace

double student_quantile(double confidence, double degrees_of_freedom) {
  if (!(confidence > 0 && confidence < 1))
    throw foundation::InvalidInput("confidence " + std::to_string(confidence) + ", must be between 0 and 1");
  if (!(degrees_of_freedom > 0))
    throw foundation::InvalidInput("degrees of freedom " + std::to_string(degrees_of_freedom) + ", must be > 0");
  const boost::math::students_t_distribution<double, PlainPolicy> student(degrees_of_freedom);
  const double above = 0.5 * (1 - confidence);
  return quantile(complement(student, above));
}

}  // namespace trivet::numerics
