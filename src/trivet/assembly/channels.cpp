// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/channels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "trivet/assembly/following.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/problems.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

using spatial::Matrix6;
using Matrix6x = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using Matrix6xc = Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic>;

class Builder {
 public:
  Builder(const model::System& system, const Assembled& assembled, MotionQuantity quantity)
      : system_(system), assembled_(assembled), derivative_(static_cast<int>(quantity)) {}

  /// All channels of one name; empty if the name is unknown.
  std::vector<Channel> word(const std::string& of) const {
    std::vector<Channel> result;
    const auto append = [&](std::vector<Channel> more) { result.insert(result.end(), more.begin(), more.end()); };
    const auto append_motions = [&](std::vector<Channel> more) {
      for (Channel& channel : more) set_ground_terms(channel);
      append(std::move(more));
    };
    if (of == "ground") append(ground());
    if (of == "base") append_motions(motions("base", [&](int j) { return base_motion(Matrix6::Identity(), j); }));
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const model::Body& body = system_.bodies()[b];
      if (of == "coordinates" || of == body.name) append_motions(coordinates(b));
      if (of == body.name + ".relative") append_motions(relative_motion(b, of, Eigen::Vector3d::Zero()));
      for (const model::Point& point : body.points) {
        if (of == body.name + "." + point.name) append_motions(point_motion(b, point));
        if (of == body.name + "." + point.name + ".relative") append_motions(relative_motion(b, of, point.at));
      }
    }
    for (std::size_t e = 0; e < system_.elements().size(); ++e) {
      const std::string& name = system_.elements()[e].name;
      if (of == name) append(forces(name, wrench_on_n(e)));
      if (of == name + ".deflection") append_motions(end_motion(e, of, true));
      if (of == name + ".foot") append_motions(end_motion(e, of, false));
    }
    return result;
  }

 private:
  std::string motion_unit(int j) const {
    static constexpr std::array<const char*, 3> translation = {"m", "m/s", "m/s²"},
                                                rotation = {"rad", "rad/s", "rad/s²"};
    return (j < 3 ? translation : rotation)[to_size(derivative_)];
  }

  std::vector<Channel> coordinates(std::size_t b) const {
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      const Eigen::Index row = assembled_.layout.row(b, j);
      if (row < 0) continue;
      Channel channel =
          empty(system_.bodies()[b].name + "." + model::coordinate_names[to_size(j)], motion_unit(j), derivative_);
      channel.on_displacement(row) = 1;
      result.push_back(std::move(channel));
    }
    return result;
  }

  std::vector<Channel> point_motion(std::size_t b, const model::Point& point) const {
    const Matrix6 x = spatial::rigid_motion(point.at);
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      Channel channel = empty(system_.bodies()[b].name + "." + point.name + "." + model::coordinate_names[to_size(j)],
                              motion_unit(j), derivative_);
      for (int i = 0; i < 6; ++i)
        if (assembled_.layout.row(b, i) >= 0) channel.on_displacement(assembled_.layout.row(b, i)) = x(j, i);
      result.push_back(std::move(channel));
    }
    return result;
  }

  template <typename Filled>
  std::vector<Channel> motions(const std::string& name, const Filled& filled) const {
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      Channel channel = filled(j);
      channel.name = name + "." + model::coordinate_names[to_size(j)];
      channel.unit = motion_unit(j);
      channel.derivative = derivative_;
      result.push_back(std::move(channel));
    }
    return result;
  }

  void set_ground(Channel& channel, const Eigen::VectorXd& on_ground) const {
    if (!on_ground.isZero(0))
      channel.ground = {on_ground.cast<std::complex<double>>(), Eigen::VectorXd::Zero(on_ground.size()),
                        Eigen::VectorXd::Zero(on_ground.size())};
  }

  /// Sets the terms of a motion on the followed ground coordinates.
  void set_ground_terms(Channel& channel) const {
    Eigen::VectorXd on_ground = Eigen::VectorXd::Zero(assembled_.ground.size());
    if (!channel.ground.empty()) on_ground = channel.ground.on_displacement.real();
    on_ground.tail(assembled_.ground.followed()) =
        followed_row(assembled_.ground, channel.on_displacement.real().transpose(), on_ground.transpose()).transpose();
    set_ground(channel, on_ground);
  }

  /// Component j of the rigid motion of the whole foundation, at the place and in the axes given by `carry`.
  Channel base_motion(const Matrix6& carry, int j) const {
    Channel channel = empty({}, {}, derivative_);
    Eigen::VectorXd on_ground = Eigen::VectorXd::Zero(assembled_.ground.size());
    on_ground.head<6>() = carry.row(j).transpose();
    set_ground(channel, on_ground);
    return channel;
  }

  /// Motion of a point of a body relative to the rigid foundation at the same place, body axes.
  std::vector<Channel> relative_motion(std::size_t b, const std::string& name, const Eigen::Vector3d& at) const {
    const spatial::Pose& pose = system_.bodies()[b].pose;
    const Matrix6 x = spatial::rigid_motion(at);
    const Matrix6 base =
        -(spatial::both_blocks(pose.rotation).transpose() * spatial::rigid_motion(pose.position + pose.rotation * at));
    std::vector<Channel> result = motions(name, [&](int j) {
      Channel channel = base_motion(base, j);
      for (int i = 0; i < 6; ++i)
        if (assembled_.layout.row(b, i) >= 0) channel.on_displacement(assembled_.layout.row(b, i)) = x(j, i);
      return channel;
    });
    for (int j = 5; j >= 0; --j)
      if (system_.bodies()[b].left_out[to_size(j)]) result.erase(result.begin() + j);
    return result;
  }

  /// Motion of end N of an element in ground axes; or motion of end K relative to N beyond a rigid motion of both, in
  /// the element's axes at N.
  std::vector<Channel> end_motion(std::size_t e, const std::string& name, bool deflection) const {
    const ElementMap& map = assembled_.elements[e];
    const model::Element& element = system_.elements()[e];
    Eigen::Matrix<double, 6, 12> pick = Eigen::Matrix<double, 6, 12>::Zero();
    const Matrix6 turn = spatial::both_blocks(model::end_in_ground(system_.bodies(), element.n).rotation);
    if (deflection) {
      const model::Span span = model::span(system_.bodies(), element.n, element.k);
      const Matrix6 k_in_n = spatial::both_blocks(span.n_from_k);
      pick.rightCols<6>() = k_in_n;
      pick.leftCols<6>() = -spatial::rigid_motion(span.n_from_k * span.arm);
    } else {
      pick.leftCols<6>() = turn;
    }
    const Eigen::MatrixXd on_free = pick * map.ends.topRows<12>(), on_ground = pick * map.ground_ends.topRows<12>();
    return motions(name, [&](int j) {
      Channel channel = empty({}, {}, derivative_);
      for (Eigen::Index c = 0; c < on_free.cols(); ++c) channel.on_displacement(map.rows[to_size(c)]) += on_free(j, c);
      Eigen::VectorXd of_ground = Eigen::VectorXd::Zero(assembled_.ground.size());
      for (Eigen::Index c = 0; c < on_ground.cols(); ++c) of_ground(map.ground_rows[to_size(c)]) += on_ground(j, c);
      set_ground(channel, of_ground);
      return channel;
    });
  }

  struct WrenchRows {
    Matrix6xc on_displacement, ground_displacement;
    Matrix6x on_velocity, on_acceleration, ground_velocity, ground_acceleration;
    std::vector<std::pair<std::size_t, Eigen::Matrix<double, 6, 12>>> dynamic;  // element, rows on D(ω)
    spatial::Vector6 at_rest = spatial::Vector6::Zero();

    void add(const Matrix6& carry, const WrenchRows& other) {
      on_displacement += carry * other.on_displacement;
      on_velocity += carry * other.on_velocity;
      on_acceleration += carry * other.on_acceleration;
      ground_displacement += carry * other.ground_displacement;
      ground_velocity += carry * other.ground_velocity;
      ground_acceleration += carry * other.ground_acceleration;
      for (const auto& [element, rows] : other.dynamic) dynamic.emplace_back(element, carry * rows);
      at_rest += carry * other.at_rest;
    }
  };

  WrenchRows no_wrench() const {
    const Eigen::Index n = assembled_.layout.size(), g = assembled_.ground.size();
    return {Matrix6xc::Zero(6, n),
            Matrix6xc::Zero(6, g),
            Matrix6x::Zero(6, n),
            Matrix6x::Zero(6, n),
            Matrix6x::Zero(6, g),
            Matrix6x::Zero(6, g),
            {},
            spatial::Vector6::Zero()};
  }

  /// Longest lever arm of the moments of this element [m].
  double longest_lever(std::size_t e) const {
    const model::Element& element = system_.elements()[e];
    return std::max(
        {element.n.at.norm(), element.k.at.norm(), model::span(system_.bodies(), element.n, element.k).arm.norm()});
  }

  /// Sets the round-off (1e-17) of products of rotation matrices to zero: a strut has no moment, a turned spring no
  /// transverse force.
  Matrix6x without_round_off(Matrix6x rows, const ElementMap& map, const Eigen::MatrixXd& matrix, double lever) const {
    constexpr double round_off = 64 * std::numeric_limits<double>::epsilon();
    double force = 0, moment = 0;
    for (int i = 0; i < 12; ++i)
      (i % 6 < 3 ? force : moment) = std::max(i % 6 < 3 ? force : moment, std::abs(matrix(i, i)));
    for (Eigen::Index j = 0; j < map.end_columns; ++j)
      for (int i = 0; i < 6; ++i) {
        const bool moment_row = i >= 3, rotation_column = is_rotation(map.rows[to_size(j)]);
        double typical = force * (moment_row ? lever : 1) * (rotation_column ? lever : 1);
        if (moment_row && rotation_column) typical += moment;
        if (std::abs(rows(i, j)) <= round_off * typical) rows(i, j) = 0;
      }
    return rows;
  }

  bool is_rotation(Eigen::Index row) const {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      for (int j = 3; j < 6; ++j)
        if (assembled_.layout.row(b, j) == row) return true;
    return false;
  }

  /// Wrench that element e exerts on its N side, ground axes, about the reference point of N.
  WrenchRows wrench_on_n(std::size_t e) const {
    const ElementMap& map = assembled_.elements[e];
    const Matrix6 turn = spatial::both_blocks(model::end_in_ground(system_.bodies(), system_.elements()[e].n).rotation);
    const double lever = longest_lever(e);
    const auto on_n = [&](const Eigen::MatrixXd& matrix) -> Matrix6x {
      return without_round_off(-(turn * matrix.topRows<6>() * map.ends), map, matrix, lever);
    };
    const Matrix6x stiffness = on_n(map.matrices.stiffness), damping = on_n(map.matrices.damping),
                   mass = on_n(map.matrices.mass);
    WrenchRows rows = no_wrench();
    for (Eigen::Index j = 0; j < map.ends.cols() && !map.frequency_dependent(); ++j) {
      const Eigen::Index row = map.rows[to_size(j)];
      rows.on_displacement.col(row) += stiffness.col(j) * std::complex<double>(1, map.matrices.loss_factor);
      rows.on_velocity.col(row) += damping.col(j);
      rows.on_acceleration.col(row) += mass.col(j);
    }
    const auto of_ground = [&](const Eigen::MatrixXd& matrix) -> Matrix6x {
      return -(turn * matrix.topRows<6>() * map.ground_ends);
    };
    const Matrix6x ground_stiffness = of_ground(map.matrices.stiffness),
                   ground_damping = of_ground(map.matrices.damping), ground_mass = of_ground(map.matrices.mass);
    for (Eigen::Index j = 0; j < map.ground_ends.cols() && !map.frequency_dependent(); ++j) {
      const Eigen::Index row = map.ground_rows[to_size(j)];
      rows.ground_displacement.col(row) += ground_stiffness.col(j) * std::complex<double>(1, map.matrices.loss_factor);
      rows.ground_velocity.col(row) += ground_damping.col(j);
      rows.ground_acceleration.col(row) += ground_mass.col(j);
    }
    if (!map.frequency_dependent()) {
      const FollowedForces followed = followed_forces(map, assembled_.ground);
      rows.ground_displacement.rightCols(assembled_.ground.followed()) =
          -(turn * followed.stiffness.topRows<6>()) * std::complex<double>(1, map.matrices.loss_factor);
      rows.ground_velocity.rightCols(assembled_.ground.followed()) = -(turn * followed.damping.topRows<6>());
      rows.ground_acceleration.rightCols(assembled_.ground.followed()) = -(turn * followed.mass.topRows<6>());
    }
    if (map.frequency_dependent()) {
      Eigen::Matrix<double, 6, 12> exact = Eigen::Matrix<double, 6, 12>::Zero();
      exact.leftCols<6>() = -turn;
      rows.dynamic.emplace_back(e, exact);
    }
    if (system_.description().gravity) rows.at_rest = turn * own_weight(e).head<6>();
    if (const auto& preload = system_.elements()[e].law.preload) rows.at_rest -= turn * preload->head<6>();
    return rows;
  }

  /// Gravity on the element's own mass as forces on its two ends.
  spatial::Vector12 own_weight(std::size_t e) const {
    const model::Element& element = system_.elements()[e];
    spatial::Vector12 fall = spatial::Vector12::Zero();
    fall.segment<3>(0) =
        model::end_in_ground(system_.bodies(), element.n).rotation.transpose() * *system_.description().gravity;
    fall.segment<3>(6) =
        model::end_in_ground(system_.bodies(), element.k).rotation.transpose() * *system_.description().gravity;
    return assembled_.elements[e].matrices.mass.topLeftCorner<12, 12>() * fall;
  }

  std::vector<Channel> ground() const {
    WrenchRows total = no_wrench();
    for (std::size_t e = 0; e < system_.elements().size(); ++e) {
      const model::End& n = system_.elements()[e].n;
      if (!n.body && !system_.elements()[e].is_foundation)
        total.add(spatial::rigid_motion(n.at).transpose(), wrench_on_n(e));
    }
    return forces("ground", total);
  }

  std::vector<Channel> forces(const std::string& name, const WrenchRows& rows) const {
    static constexpr std::array<const char*, 6> parts = {"force.x",  "force.y",  "force.z",
                                                         "moment.x", "moment.y", "moment.z"};
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      Channel channel = empty(name + "." + parts[to_size(j)], j < 3 ? "N" : "N m", 0);
      channel.on_displacement = rows.on_displacement.row(j).transpose();
      channel.on_velocity = rows.on_velocity.row(j).transpose();
      channel.on_acceleration = rows.on_acceleration.row(j).transpose();
      if (!rows.ground_displacement.row(j).isZero(0) || !rows.ground_velocity.row(j).isZero(0) ||
          !rows.ground_acceleration.row(j).isZero(0))
        channel.ground = {rows.ground_displacement.row(j).transpose(), rows.ground_velocity.row(j).transpose(),
                          rows.ground_acceleration.row(j).transpose()};
      for (const auto& [element, exact] : rows.dynamic) channel.dynamic_forces.push_back({element, exact.row(j)});
      channel.at_rest = rows.at_rest(j);
      result.push_back(std::move(channel));
    }
    return result;
  }

  Channel empty(std::string name, std::string unit, int derivative) const {
    const Eigen::Index n = assembled_.layout.size();
    return {{Eigen::VectorXcd::Zero(n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)},
            std::move(name),
            std::move(unit),
            derivative,
            {},
            {},
            0};
  }

  const model::System& system_;
  const Assembled& assembled_;
  int derivative_;
};

}  // namespace

std::vector<numerics::ObservedCurve> curves(const std::vector<Channel>& channels) {
  std::vector<numerics::ObservedCurve> result;
  for (const Channel& channel : channels) result.push_back(channel.curve());
  return result;
}

std::vector<std::string> channel_words(const model::Description& description) {
  std::vector<std::string> words = {"coordinates", "ground", "base"};
  for (const auto& body : description.bodies) {
    for (const char* kind : {"", ".relative"}) {
      words.push_back(body.name + kind);
      for (const auto& point : body.points) words.push_back(body.name + "." + point.name + kind);
    }
  }
  for (const auto& element : description.elements)
    for (const char* kind : {"", ".deflection", ".foot"}) words.push_back(element.name + kind);
  return words;
}

std::vector<Channel> channels(const model::System& system, const Assembled& assembled,
                              const std::vector<std::string>& of, MotionQuantity quantity) {
  const Builder builder(system, assembled, quantity);
  std::vector<Channel> result;
  std::set<std::string> seen;
  const auto append_new = [&](const std::vector<Channel>& more) {
    for (const Channel& channel : more)
      if (seen.insert(channel.name).second) result.push_back(channel);
  };
  for (const std::string& word : of) {
    std::vector<Channel> found = builder.word(word);
    if (found.empty())
      for (const std::string& group : channel_words(system.description()))
        if (word.starts_with(group + "."))
          for (Channel& channel : builder.word(group))
            if (channel.name == word) found.push_back(std::move(channel));
    if (found.empty()) {
      std::vector<std::string> names;
      for (const std::string& group : channel_words(system.description()))
        for (const Channel& channel : builder.word(group)) names.push_back(channel.name);
      const std::string guess = foundation::nearest_name(word, names);
      throw foundation::InvalidInput("\"" + word + "\" is not a result of this model" +
                                     (guess.empty() ? "" : "; did you mean \"" + guess + "\"?"));
    }
    append_new(found);
  }
  return result;
}

}  // namespace trivet::assembly
