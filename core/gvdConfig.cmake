# SPDX-License-Identifier: MIT
#
# What find_package(gvd) reads: gvd::gvd, and gvd::gltf if that was built.

include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
include(${CMAKE_CURRENT_LIST_DIR}/gvdTargets.cmake)
