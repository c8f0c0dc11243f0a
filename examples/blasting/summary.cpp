// SPDX-License-Identifier: MIT
#include "summary.hpp"
#include <mpm/io/text.hpp>
#include <string_view>
#include <utility>

namespace blasting {
namespace {

/// A JSON object in the making, members in order of addition.
class Object {
 public:
  explicit Object(std::string indent = "  ") : indent_(std::move(indent)) {}

  Object& add(std::string_view name, const std::string& json) {
    members_ += (members_.empty() ? "\n" : ",\n") + indent_ + mpm::io::json_string(name) + ": " + json;
    return *this;
  }
  Object& add(std::string_view name, double value) { return add(name, mpm::io::json_number(value)); }
  Object& add(std::string_view name, std::int64_t value) { return add(name, std::to_string(value)); }
  Object& add(std::string_view name, const Object& object) { return add(name, object.text()); }

  std::string text() const { return "{" + members_ + "\n" + indent_.substr(2) + "}"; }

 private:
  std::string indent_;
  std::string members_;
};

}  // namespace

void write_summary(const std::filesystem::path& file, const Summary& s) {
  const Object nested("    ");
  Object energy = nested;
  for (const auto& [name, value] : s.energy) energy.add(name, value);
  Object json;
  json.add("completed", std::string(s.completed ? "true" : "false"))
      .add("simulated_seconds", s.simulated_seconds)
      .add("wall_seconds", s.wall_seconds)
      .add("cpu_seconds", s.cpu_seconds)
      .add("steps", Object(nested).add("relaxation", s.steps.relaxation).add("blast", s.steps.blast))
      .add("particles",
           Object(nested).add("rock", s.particles.rock).add("charge", s.particles.charge).add("air", s.particles.air))
      .add("relaxation", Object(nested)
                             .add("unbalanced_force", s.relaxation.unbalanced_force)
                             .add("kinetic_ratio", s.relaxation.kinetic_ratio))
      .add("crack", Object(nested)
                        .add("reach", s.crack.reach)
                        .add("along_x", s.crack.along_x)
                        .add("along_y", s.crack.along_y)
                        .add("longest", s.crack.longest)
                        .add("area", s.crack.area)
                        .add("crushed_area", s.crack.crushed_area)
                        .add("crushed_radius", s.crack.crushed_radius))
      .add("wall_radial_stress", s.wall_radial_stress)
      .add("energy", energy)
      .add("threads", std::int64_t{s.threads})
      .add("state_hash", mpm::io::json_string(s.state_hash));
  mpm::io::replace_file(file, json.text() + "\n");
}

}  // namespace blasting
