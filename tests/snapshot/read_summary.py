# SPDX-License-Identifier: MIT
"""Checks a summary.json against the values summary_test.cpp wrote. Usage: read_summary.py FILE."""
import json
import sys


def refuse(constant):
    raise ValueError(constant + " is not JSON")


with open(sys.argv[1], encoding="utf-8") as file:
    found = json.load(file, parse_constant=refuse)

expected = {
    "completed": True,
    "simulated_seconds": 1 / 3e4,
    "wall_seconds": 301.5,
    "cpu_seconds": 512.25,
    "steps": {"relaxation": 4000, "blast": 12345678901},
    "particles": {"rock": 40000, "charge": 2000, "air": 700},
    "relaxation": {"unbalanced_force": 1e-10, "kinetic_ratio": 2.5e-12},
    "crack": {"reach": 0.658, "along_x": 0.391, "along_y": None, "longest": 0.7, "area": 0.2721,
              "crushed_area": 0.0117, "crushed_radius": 0.0625},
    "wall_radial_stress": -1.5e6,
    "energy": {"charge": 5e6, "dissipated \"crack\"": 0.1},
    "threads": 3,
    "state_hash": "0123456789abcdef",
}
assert found == expected, found


def types(value):
    if isinstance(value, dict):
        return {name: types(member) for name, member in value.items()}
    return float if isinstance(value, (int, float)) and not isinstance(value, bool) else type(value)


assert types(found) == types(expected), types(found)
assert list(found) == list(expected), "order"
