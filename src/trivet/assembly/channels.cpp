// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/channels.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "trivet/assembly/channel_rows.h"
#include "trivet/assembly/following.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/problems.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

using spatial::Matrix6;

constexpr std::array names_of_motions = {"displacement", "velocity", "acceleration"};

/// Is a word this name and this ending? Nothing is joined: words are compared with every name of a model.
bool is(std::string_view word, std::string_view name, std::string_view ending) {
  return word.size() == name.size() + ending.size() && word.starts_with(name) && word.ends_with(ending);
}

class Builder {
 public:
  Builder(const model::System& system, const Assembled& assembled, MotionQuantity quantity)
      : system_(system), assembled_(assembled), derivative_(static_cast<int>(quantity)) {}

  /// All channels of one name; empty if the name is unknown.
  std::vector<Channel> word(const std::string& of) const {
    std::vector<Channel> result;
    const auto append = [&](std::vector<Channel> more) { std::ranges::move(more, std::back_inserter(result)); };
    const auto append_motions = [&](std::vector<Channel> more) {
      for (Channel& channel : more) set_ground_terms(channel);
      append(std::move(more));
    };
    if (of == "ground") append(ground());
    if (of == "base") append_motions(motions("base", [&](int j) { return base_motion(Matrix6::Identity(), j); }));
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const model::Body& body = system_.bodies()[b];
      if (of == "coordinates" || of == body.name) append_motions(coordinates(b));
      if (is(of, body.name, ".relative")) append_motions(relative_motion(b, of, Eigen::Vector3d::Zero()));
      for (const model::Point& point : body.points) {
        const std::string name = body.name + "." + point.name;
        if (of == name) append_motions(point_motion(b, point));
        if (is(of, name, ".relative")) append_motions(relative_motion(b, of, point.at));
      }
    }
    for (std::size_t e = 0; e < system_.elements().size(); ++e) {
      const std::string& name = system_.elements()[e].name;
      if (of == name) append(forces(name, wrench_on_n(system_, assembled_, e)));
      if (is(of, name, ".deflection")) append_motions(end_motion(e, of, true));
      if (is(of, name, ".foot")) append_motions(end_motion(e, of, false));
    }
    const model::Description& description = system_.description();
    for (const model::RelativeMotion& motion : description.relative_motions)
      if (of == motion.name) append_motions(relative_motion(motion));
    for (const model::Clearance& clearance : description.clearances)
      if (of == clearance.name) append_motions({approach(clearance)});
    for (const model::Section& section : description.sections)
      if (of == section.name) append(forces(section.name, section_wrench(system_, assembled_, section)));
    return result;
  }

 private:
  std::string motion_unit(int j) const {
    static constexpr std::array<const char*, 3> translation = {"m", "m/s", "m/s²"},
                                                rotation = {"rad", "rad/s", "rad/s²"};
    return (j < 3 ? translation : rotation)[derivative_];
  }

  std::vector<Channel> coordinates(std::size_t b) const {
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      const Eigen::Index row = assembled_.layout.row(b, j);
      if (row < 0) continue;
      Channel channel = empty(system_.bodies()[b].name + "." + model::coordinate_names[j], motion_unit(j), derivative_);
      channel.on_displacement(row) = 1;
      result.push_back(std::move(channel));
    }
    return result;
  }

  std::vector<Channel> point_motion(std::size_t b, const model::Point& point) const {
    const Matrix6 x = spatial::rigid_motion(point.at);
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      Channel channel = empty(system_.bodies()[b].name + "." + point.name + "." + model::coordinate_names[j],
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
      channel.name = name + "." + model::coordinate_names[j];
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
      if (system_.bodies()[b].left_out[j]) result.erase(result.begin() + j);
    return result;
  }

  /// Row j of the motion of one place less that of another.
  Channel row_channel(const MotionRows& rows, int j, const std::string& name, const char* component) const {
    Channel channel = empty(name + "." + component, motion_unit(j), derivative_);
    channel.on_displacement = rows.on_coordinates.row(j).transpose().cast<std::complex<double>>();
    set_ground(channel, rows.on_ground.row(j).transpose());
    return channel;
  }

  std::vector<Channel> relative_motion(const model::RelativeMotion& motion) const {
    const MotionRows rows = motion_between(system_, assembled_, motion.of, motion.to, motion.axes);
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j)
      if (!model::is_left_out(system_.bodies(), motion, j))
        result.push_back(row_channel(rows, j, motion.name, model::relative_components[j]));
    return result;
  }

  /// Positive if the places move towards each other.
  Channel approach(const model::Clearance& clearance) const {
    const Eigen::Matrix3d axes = spatial::axes_along(clearance.direction);
    constexpr int along = 2;
    return row_channel(motion_between(system_, assembled_, clearance.of, clearance.to, axes), along, clearance.name,
                       model::approach_component);
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
      for (Eigen::Index c = 0; c < on_free.cols(); ++c) channel.on_displacement(map.rows[c]) += on_free(j, c);
      Eigen::VectorXd of_ground = Eigen::VectorXd::Zero(assembled_.ground.size());
      for (Eigen::Index c = 0; c < on_ground.cols(); ++c) of_ground(map.ground_rows[c]) += on_ground(j, c);
      set_ground(channel, of_ground);
      return channel;
    });
  }

  std::vector<Channel> ground() const {
    WrenchRows total(assembled_);
    for (std::size_t e = 0; e < system_.elements().size(); ++e) {
      const model::End& n = system_.elements()[e].n;
      if (!n.body && !system_.elements()[e].is_foundation)
        total.add(spatial::rigid_motion(n.at).transpose(), wrench_on_n(system_, assembled_, e));
    }
    return forces("ground", total);
  }

  std::vector<Channel> forces(const std::string& name, const WrenchRows& rows) const {
    static constexpr std::array<const char*, 6> parts = {"force.x",  "force.y",  "force.z",
                                                         "moment.x", "moment.y", "moment.z"};
    std::vector<Channel> result;
    for (int j = 0; j < 6; ++j) {
      Channel channel = empty(name + "." + parts[j], j < 3 ? "N" : "N m", 0);
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

const char* motion_name(MotionQuantity quantity) { return names_of_motions.at(static_cast<std::size_t>(quantity)); }

std::vector<std::string> motion_names() { return {names_of_motions.begin(), names_of_motions.end()}; }

MotionQuantity motion_quantity(std::string_view name) {
  const auto found = std::ranges::find(names_of_motions, name);
  if (found == names_of_motions.end()) throw foundation::InvalidInput("unknown quantity of motion");
  return static_cast<MotionQuantity>(found - names_of_motions.begin());
}

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
  for (const auto& motion : description.relative_motions) words.push_back(motion.name);
  for (const auto& section : description.sections) words.push_back(section.name);
  for (const auto& clearance : description.clearances) words.push_back(clearance.name);
  return words;
}

std::vector<Channel> channels(const model::System& system, const Assembled& assembled,
                              const std::vector<std::string>& of, MotionQuantity quantity) {
  const Builder builder(system, assembled, quantity);
  std::vector<Channel> result;
  std::set<std::string> seen;
  const auto append_new = [&](std::vector<Channel> more) {
    for (Channel& channel : more)
      if (seen.insert(channel.name).second) result.push_back(std::move(channel));
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
    append_new(std::move(found));
  }
  return result;
}

}  // namespace trivet::assembly
