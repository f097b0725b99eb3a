# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: Romanesco authors
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(Boost CONFIG)
find_dependency(hwy)
include(${CMAKE_CURRENT_LIST_DIR}/RomanescoCore.cmake)
