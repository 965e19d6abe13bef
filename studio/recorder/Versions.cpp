#include "studio/recorder/Versions.hpp"

#include <SuiteSparse_config.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <oneapi/tbb/version.h>

#include <Eigen/Core>

namespace thinwall {

std::string thinwall_version() {
  return THINWALL_VERSION;
}

std::string effective_licence() {
  return "GPL-2.0-or-later, taken at version 3 (own sources: MIT; SuiteSparse's supernodal CHOLMOD: GPL-2.0-or-later; "
         "METIS and oneTBB: Apache-2.0)";
}

std::vector<std::pair<std::string, std::string>> component_versions() {
  return {{"thinwall", thinwall_version()},
          {"compiler", "g++ " __VERSION__},
          {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"SuiteSparse",
           fmt::format("{}.{}.{}", SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION)},
          {"oneTBB", fmt::format("{}.{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH)},
          {"HDF5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE)}};
}

}  // namespace thinwall
