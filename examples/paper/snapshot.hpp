// SPDX-License-Identifier: MIT
#pragma once
#include "case.hpp"
#include <blasting/pictures.hpp>
#include <vector>

namespace paper {

/// The rock as a blast left it, a particle an entry.
struct Rock {
  std::vector<blasting::Quad> domain{};
  std::vector<double> crushed{}, cracked{};
};

/// The rock of the run's last snapshot. Throws std::runtime_error naming the file if it cannot be read.
Rock read_rock(const Blast& blast);

/// Damage of the rock on the pixels of a picture of the given half width, m, about the middle of the holes.
std::vector<float> damage_picture(const Rock& rock, const blasting::Scene& scene, double half_width);

/// Area, m2, of a particle's domain, and its centre.
double area(const blasting::Quad& quad);
blasting::Vec2 centre(const blasting::Quad& quad);

}  // namespace paper
