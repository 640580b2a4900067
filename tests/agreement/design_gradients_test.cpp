// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <map>
#include <random>

#include "support/projects.h"
#include "support/quad_machine.h"
#include "support/quad_model.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/family/requirement_slopes.h"
#include "trivet/study/requirements/requirement_values.h"

/// Slopes of the margins of every kind of requirement against differences of the fourth order of models that are solved
/// again in quadruple precision, on random skew machines with all kinds of damping.
namespace design_gradients_test {

using namespace trivet;
using study::RequirementKind;
using study::RequirementResult;
using test::ChannelNumbers;
using test::Quad;
using test::QuadComplex;
using test::QuadFactors;
using test::QuadMachine;
using test::QuadMatrix;
using test::QuadPair;
using Candidate = RequirementResult::Candidate;

/// Demanded of every slope over the whole range of its parameter, as a share of the largest slope of the same margin.
/// Where all are smaller than `noticeable`, such as those of a damping ratio that does not change, of this.
constexpr double exact = 1e-9, noticeable = 1e-3;

/// A skew body and a smaller one on it, to first order of its weight: forces at rest are no polynomials of a number
/// (design_slopes_test has them).
/// @param of_mounts  their damping
/// @param of_link    that of the element between the bodies
std::string machine(unsigned seed, const std::string& of_mounts, const std::string& of_link) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> around(0.8, 1.25);
  const auto some = [&](double value) { return fmt::format("{}", value * around(random)); };
  std::string text = "trivet = 1\nsecond_order = false\ngravity = [0, 0, -9.80665]\n";
  text += "[bodies.machine]\nmass = " + some(120) + "\ncenter_of_mass = [" + some(0.03) + ", 0.02, " + some(0.2) +
      "]\ninertia = {about = \"center_of_mass\", xx = " + some(6) + ", yy = " + some(9) + ", zz = " + some(7) +
      ", xy = 0.4, xz = -0.7}\npoints.seat = [0.3, 0.1, 0.4]\n";
  text += "[bodies.box]\nmass = " + some(8) + "\nposition = [0.1, 0.05, 0.5]\nfree = [\"x\", \"y\", \"z\"]\n";
  for (const auto& [name, x, y] : {std::tuple{"a", 0.4, 0.3}, {"b", -0.4, 0.3}, {"c", 0.4, -0.3}, {"d", -0.4, -0.3}})
    text += fmt::format(
        "[elements.{}]\ntype = \"bushing\"\non = \"machine\"\nat = [{}, {}, 0]\ntranslation = [{}, {}, {}]\nrotation = "
        "[20, 20, 20]\norientation = {{axis = [1, 0.3, 0.1], angle = {}}}\n{}",
        name, x, y, some(9e4), some(7e4), some(2e5), some(0.3), of_mounts);
  text +=
      "[elements.link]\ntype = \"bushing\"\non = \"box\"\nfrom = \"machine\"\nat = [0, 0, 0]\ntranslation = [4e4, "
      "3e4, " +
      some(6e4) + "]\n" + of_link;
  text +=
      "[excitations.f]\ntype = \"harmonic\"\non = \"machine\"\nat = [0.2, 0.1, 0.3]\nforce = [20, 10, 50]\n"
      "[excitations.r]\ntype = \"random\"\non = \"machine\"\nat = [0.1, 0.2, 0.3]\nforce = [1, 0.5, 2]\n"
      "psd = [[2, 100], [25, 100]]\n"
      "[parameters.scale]\npath = [\"elements.a.scale\", \"elements.b.scale\"]\nfrom = 0.5\nto = 2\nspacing = "
      "\"logarithmic\"\n"
      "[parameters.spread]\npath = {\"elements.c.at.y\" = 1, \"elements.a.at.y\" = -1}\nfrom = -0.5\nto = -0.1\n"
      "[parameters.mass]\npath = \"bodies.box.mass\"\nfrom = 5\nto = 15\n"
      "[parameters.height]\npath = \"bodies.machine.center_of_mass.z\"\nfrom = 0.1\nto = 0.3\n"
      "[analyses.response]\nband = [\"3 Hz\", \"25 Hz\"]\n[analyses.random]\n"
      "[limit_lines.line]\nof = \"machine.seat.y\"\nquantity = \"velocity\"\nrows = [[1, 1e-2], [100, 2e-4]]\n"
      "[requirements]\nlimits = {\"machine.seat.z\" = \"1 mm\", \"box.x\" = \"3 mm/s\", \"ground.force.z\" = 300, "
      "\"link.deflection.z\" = \"0.2 mm\"}\nno_peak = \"machine.seat.z\"\nlimit_lines = [\"line\"]\n"
      "natural_frequencies = {avoid = [[\"9 Hz\", \"15 Hz\"]], separation = 1.1}\ndamping_ratio = 0.05\n"
      "decoupling = {machine = \"70 %\"}\nstatic = {\"machine.z\" = \"5 mm\", \"ground.force.z\" = 900, "
      "\"a.deflection.z\" = \"1 mm\"}\nrms = {\"machine.seat.z\" = \"0.05 m/s2\", \"ground.force.z\" = 5}\n";
  return text;
}

/// A design of a project, its slopes, and the same models in quadruple precision.
class Comparison {
 public:
  /// Of the range, for the differences: truncation and round-off are far below the tolerance.
  static constexpr double relative_step = 1e-7;

  /// @param modal_damping  a table for the file, or empty
  Comparison(const std::string& text, const std::string& modal_damping = "", std::vector<double> modal_ratios = {})
      : project_(test::project(text + modal_damping)),
        without_modal_damping_(test::project(text)),
        base_(project_.base()),
        space_(project_, {}),
        modal_ratios_(std::move(modal_ratios)),
        shares_(Eigen::VectorXd::LinSpaced(to_index(space_.size()), 0.37, 0.61)),
        values_(space_.values(shares_)),
        system_(space_.system(base_, values_)),
        context_(system_, silent_),
        moved_(space_.size()) {
    foundation::Problems warnings;
    results_ = study::requirement_values(context_, base_.analyses, warnings);
    // Loads across a mount without a range there are listed, and not judged.
    std::erase_if(results_, [](const RequirementResult& result) {
      return result.kind == RequirementKind::mount_load && !result.value;
    });
    for (const RequirementResult& result : results_) {
      EXPECT_TRUE(result.value) << result.words.text() << ": " << result.reason;
      if (const std::string channel = channel_name(result); !channel.empty())
        channels_.emplace_back(channel, result.quantity);
    }
    for (std::size_t j = 0; j < space_.size(); ++j) {
      const project::DesignAxis& axis = space_.axes()[j];
      std::array<double, 5> at;
      for (std::size_t i = 0; i < at.size(); ++i)
        at[i] = axis.from + static_cast<double>(i) / 4 * (axis.to - axis.from);
      const test::QuadFamily family(at, [&](double value) {
        Eigen::VectorXd moved = values_;
        moved(to_index(j)) = value;
        return numbers(space_.system(without_modal_damping_.base(), moved));
      });
      const Quad step = relative_step * (axis.to - axis.from);
      for (const int node : {-2, -1, 1, 2})
        moved_[j].emplace_back(family(values_(to_index(j)) + node * step), modal_ratios_);
    }
  }

  /// Compares all candidates of all requirements. @returns their number
  int compare() {
    const study::RequirementSlopes slopes(context_, space_, base_, values_);
    int compared = 0;
    for (std::size_t r = 0; r < results_.size(); ++r) {
      const RequirementResult& result = results_[r];
      std::vector<Candidate> candidates = result.candidates;
      if (candidates.empty()) candidates = {{result.margin}};
      const Eigen::MatrixXd found = slopes.of(r, result, candidates);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (!(candidates[i].margin > 0)) continue;
        expect_equal(result, candidates[i], found.row(to_index(i)));
        ++compared;
      }
    }
    return compared;
  }

 private:
  void expect_equal(const RequirementResult& result, const Candidate& candidate, const Eigen::RowVectorXd& found) {
    Eigen::RowVectorXd expected(found.size()), in_shares(found.size());
    for (std::size_t j = 0; j < moved_.size(); ++j) {
      std::array<Quad, 4> values;
      for (std::size_t i = 0; i < 4; ++i) values[i] = logarithm(moved_[j][i], result, candidate);
      in_shares(to_index(j)) = space_.axes()[j].to - space_.axes()[j].from;
      const Quad difference = (values[0] - values[3] + 8 * (values[2] - values[1])) / (12 * Quad(relative_step));
      expected(to_index(j)) = static_cast<double>(difference) / in_shares(to_index(j));
    }
    const Eigen::RowVectorXd error = (found - expected).cwiseProduct(in_shares).cwiseAbs();
    const double largest = std::max(noticeable, expected.cwiseProduct(in_shares).cwiseAbs().maxCoeff());
    for (Eigen::Index j = 0; j < found.size(); ++j)
      EXPECT_LE(error(j), exact * largest)
          << result.words.text() << ", candidate at " << candidate.angular_frequency << " rad/s, mode "
          << candidate.mode << ", " << space_.axes()[j].name << ": " << found(j) << " instead of " << expected(j);
  }

  /// The result that a requirement bounds; the axes of a mount are those of the ground.
  static std::string channel_name(const RequirementResult& result) {
    if (result.kind == RequirementKind::decoupling) return "";
    if (result.kind == RequirementKind::mount_load)
      return result.subject + ".force." + model::coordinate_names[result.direction];
    if (result.kind == RequirementKind::mount_deflection) return result.subject + ".deflection.z";
    return result.subject;
  }

  [[nodiscard]] std::size_t channel_of(const RequirementResult& result) const {
    for (std::size_t c = 0; c < channels_.size(); ++c)
      if (channels_[c] == std::pair(channel_name(result), result.quantity)) return c;
    throw std::logic_error("no channel of " + result.words.text());
  }

  test::QuadFamily::Numbers numbers(const model::System& system) const {
    const assembly::Assembled assembled = assembly::assemble(system);
    const numerics::DynamicMatrices& m = assembled.matrices;
    const auto vector_of = [&](const assembly::Loading& loading) {
      return Eigen::MatrixXd(assembly::right_side(assembled, loading).terms().front().value.real());
    };
    const model::Body& body = system.bodies()[0];
    spatial::Matrix6 of_body = body.mass.mass * spatial::Matrix6::Identity();
    of_body.bottomRightCorner<3, 3>() = body.mass.inertia_about_centre;
    const spatial::Matrix6 at_centre = spatial::rigid_motion(body.mass.centre);
    test::QuadFamily::Numbers list = {m.A,
                                      m.B,
                                      m.K,
                                      m.lossy() ? m.K_loss : Eigen::MatrixXd(0 * m.K),
                                      assembly::static_load(system, assembled),
                                      vector_of(assembly::harmonic_loading(system, assembled)),
                                      vector_of(response::random_loading(system, assembled).inputs.front().loading),
                                      at_centre,
                                      of_body};
    for (const auto& [subject, quantity] : channels_) {
      const assembly::Channel channel = assembly::channels(system, assembled, {subject}, quantity).front();
      list.push_back(channel.on_displacement.real().transpose());
      list.push_back(channel.on_displacement.imag().transpose());
      list.push_back(channel.on_velocity.transpose());
      list.push_back(Eigen::MatrixXd::Constant(1, 1, channel.at_rest));
    }
    return list;
  }

  /// ln(margin) of a candidate, without constants.
  [[nodiscard]] Quad logarithm(const QuadMachine& m, const RequirementResult& result,
                               const Candidate& candidate) const {
    switch (result.kind) {
      case RequirementKind::amplitude:
        return -height(m, result, candidate.angular_frequency, test::force, 0);
      case RequirementKind::limit_line: {
        const Quad exponent = log(Quad(2e-4) / Quad(1e-2)) / log(Quad(100));
        return -height(m, result, candidate.angular_frequency, test::force, exponent);
      }
      case RequirementKind::no_peak: {
        const Quad ratio = height(m, result, candidate.angular_frequency, test::force, 0) -
            height(m, result, candidate.minimum_at, test::force, 0);
        if (candidate.margin < 1) return -ratio;
        return -log(exp(ratio) - 1);
      }
      case RequirementKind::avoided_frequencies:
        return (candidate.below ? -1 : 1) * natural(m, candidate.mode);
      case RequirementKind::separation:
        return natural(m, candidate.mode + 1) - natural(m, candidate.mode);
      case RequirementKind::damping_ratio: {
        const QuadComplex root = root_near(m, context_.roots().list[candidate.mode - 1].eigenvalue);
        return log(-root.real()) - log(root.real() * root.real() + root.imag() * root.imag()) / 2;
      }
      case RequirementKind::decoupling:
        return log(share(m, candidate.mode));
      case RequirementKind::rms:
        return -log(variance(m, channel_of(result))) / 2;
      case RequirementKind::static_value:
      case RequirementKind::mount_deflection:
        return -log(at_rest(m, result));
      case RequirementKind::mount_load: {
        const Quad load = at_rest(m, result);
        for (const model::Element& element : system_.elements())
          if (element.name == result.subject) {
            const Eigen::Vector2d& range = *element.rating->load[result.direction];
            const Quad upper = log((*result.value > 0 ? range(1) : -range(0)) / load);
            return range(0) > 0 ? std::min<Quad>(upper, log(load / range(0))) : upper;
          }
        throw std::logic_error("no mount " + result.subject);
      }
      default:
        throw std::logic_error("no reference for " + result.words.text());
    }
  }

  /// ln|y| − exponent ln ω at the maximum or minimum near ω, or at ω where there is none.
  [[nodiscard]] Quad height(const QuadMachine& m, const RequirementResult& result, double at, std::size_t load,
                            const Quad& exponent) const {
    const std::size_t channel = channel_of(result);
    Quad omega = at;
    constexpr double near = 1e-6, settled = 1e-25;
    for (int i = 0; i < 6; ++i) {
      const QuadMachine::Curve curve = m.curve(channel, derivative(channel), omega, load);
      const Quad step = -(curve.first - exponent / omega) / (curve.second + exponent / (omega * omega));
      if (abs(step) > near * omega) return m.curve(channel, derivative(channel), at, load).value;
      omega += step;
      if (abs(step) <= settled * omega) break;
    }
    return m.curve(channel, derivative(channel), omega, load).value - exponent * log(omega);
  }

  [[nodiscard]] Quad at_rest(const QuadMachine& m, const RequirementResult& result) const {
    const ChannelNumbers of = m.channel(channel_of(result));
    const QuadMatrix q = m.number(test::stiffness).partialPivLu().solve(m.number(test::at_rest_load));
    return abs((of.re * q)(0, 0) + of.at_rest(0, 0));
  }

  static Quad natural(const QuadMachine& m, int mode) { return log(m.modes().lambda(mode - 1)) / 2; }

  static QuadComplex root_near(const QuadMachine& m, const std::complex<double>& start) {
    QuadComplex root(start.real(), abs(Quad(start.imag())));
    QuadPair v{QuadMatrix::Constant(m.number(test::mass).rows(), 1, 1),
               QuadMatrix::Zero(m.number(test::mass).rows(), 1)};
    v = QuadFactors(m.at_root(root * QuadComplex(1 + Quad(1e-12)))).solve(v);
    for (int i = 0; i < 8; ++i) {
      const QuadPair u = QuadFactors(m.at_root(root)).solve(m.slope_at_root(root) * v);
      const Quad square = (v.re.squaredNorm() + v.im.squaredNorm());
      const QuadComplex share((v.re.transpose() * u.re + v.im.transpose() * u.im)(0, 0) / square,
                              (v.re.transpose() * u.im - v.im.transpose() * u.re)(0, 0) / square);
      root -= QuadComplex(1) / share;
      const Quad length = sqrt(u.re.squaredNorm() + u.im.squaredNorm());
      v = u * QuadComplex(1 / length);
    }
    return root;
  }

  /// Share of the purest coordinate of a mode of the machine, the box held.
  [[nodiscard]] static Quad share(const QuadMachine& m, int mode) {
    const test::QuadModes own =
        test::quad_modes(m.number(test::stiffness).topLeftCorner(6, 6), m.number(test::mass).topLeftCorner(6, 6));
    const QuadMatrix at_centre = m.number(test::motion) * own.shapes.col(mode - 1),
                     moved = m.number(test::momentum) * at_centre;
    return at_centre.cwiseProduct(moved).maxCoeff();
  }

  /// Of all bounded results, by a rule whose panels are narrower than the damping of the roots.
  [[nodiscard]] Quad variance(const QuadMachine& m, std::size_t channel) const {
    const auto known = variances_.find(&m);
    if (known != variances_.end()) return known->second[channel];
    const response::RandomLoading loading = response::random_loading(context_.system, context_.assembled);
    const excitation::Spectrum& spectrum = loading.inputs.front().spectrum;  // constant in between
    using Rule = boost::math::quadrature::gauss<Quad, 25>;
    constexpr int panels = 60;
    const Quad h = (Quad(spectrum.to()) - Quad(spectrum.from())) / (2 * panels);
    std::vector<Quad> sums(channels_.size());
    for (int p = 0; p < panels; ++p)
      for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
        for (const int sign : {1, -1}) {
          if (sign < 0 && Rule::abscissa()[i] == 0) continue;
          const Quad omega = spectrum.from() + h * (2 * p + 1 + sign * Rule::abscissa()[i]);
          const QuadPair q = m.response(omega, test::random_force);
          for (std::size_t c = 0; c < channels_.size(); ++c) {
            const QuadComplex y = m.value(c, q, omega);
            sums[c] +=
                h * Rule::weights()[i] * pow(omega, 2 * derivative(c)) * (y.real() * y.real() + y.imag() * y.imag());
          }
        }
    return variances_.emplace(&m, std::move(sums)).first->second[channel];
  }

  /// Of a motion; a force has none.
  [[nodiscard]] int derivative(std::size_t channel) const {
    const auto& [name, quantity] = channels_[channel];
    return name.find(".force.") == std::string::npos ? static_cast<int>(quantity) : 0;
  }

  const project::Project project_, without_modal_damping_;
  const project::Case& base_;
  const study::DesignSpace space_;
  const std::vector<double> modal_ratios_;
  const foundation::Progress silent_;
  const Eigen::VectorXd shares_, values_;
  const model::System system_;
  const study::CaseContext context_;
  std::vector<RequirementResult> results_;
  std::vector<std::pair<std::string, assembly::MotionQuantity>> channels_;
  mutable std::map<const QuadMachine*, std::vector<Quad>> variances_;
  std::vector<std::vector<QuadMachine>> moved_;  ///< per parameter: 2 and 1 steps below, 1 and 2 above
};

constexpr int most_of_the_candidates = 40;

TEST(DesignGradients, AgreeWithQuadruplePrecisionUnderLossFactors) {
  EXPECT_GE(Comparison(machine(1, "damping = {loss_factor = 0.1}\n", "damping = {loss_factor = 0.05}\n")).compare(),
            most_of_the_candidates);
}

/// One mount carries less than its range, the other one more than half of the upper end of its range.
TEST(DesignGradients, AgreeWithQuadruplePrecisionForMountsOfACatalogue) {
  const std::string feet =
      "[elements.foot]\ntype = \"catalogue:cone S 45 ShA\"\ncatalogue = \"" TRIVET_SOURCE_DIR
      "/examples/genset/catalogue/cones.toml\"\non = \"machine\"\nat = [0.45, 0.1, 0]\n"
      "[elements.pad]\ntype = \"catalogue:disc 50x25 40 ShA\"\non = \"machine\"\nat = [-0.45, 0.05, 0]\n";
  const std::string text = machine(2, "damping = {loss_factor = 0.1}\n", "damping = {loss_factor = 0.05}\n");
  EXPECT_GE(Comparison(text + "mount_load = \"catalogue\"\n" + feet).compare(), most_of_the_candidates);
}

TEST(DesignGradients, AgreeWithQuadruplePrecisionUnderViscousDamping) {
  const std::string viscous = "damping = {translation = [150, 120, 300], rotation = [1, 1, 1]}\n";
  EXPECT_GE(Comparison(machine(3, viscous, viscous)).compare(), most_of_the_candidates);
}

TEST(DesignGradients, AgreeWithQuadruplePrecisionUnderProportionalDamping) {
  const std::string proportional = "damping = {proportional = 2e-3}\n";
  EXPECT_GE(Comparison(machine(5, proportional, proportional)).compare(), most_of_the_candidates);
}

TEST(DesignGradients, AgreeWithQuadruplePrecisionUnderModalDamping) {
  EXPECT_GE(Comparison(machine(6, "", "damping = {translation = [20, 30, 40]}\n"),
                       "[damping]\nmodal = [0.03, 0.04, 0.05, 0.04, 0.06, 0.05, 0.04, 0.03, 0.05]\n",
                       {0.03, 0.04, 0.05, 0.04, 0.06, 0.05, 0.04, 0.03, 0.05})
                .compare(),
            most_of_the_candidates);
}

}  // namespace design_gradients_test
