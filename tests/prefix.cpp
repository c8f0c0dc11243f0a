// SPDX-License-Identifier: MIT
// Of the headers that tests have in common; see CMakeLists.txt.
