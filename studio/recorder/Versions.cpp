#include "studio/recorder/Versions.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <metis.h>
#include <oneapi/tbb/version.h>

#include <Eigen/Core>

namespace thinwall {

std::string thinwall_version() {
  return THINWALL_VERSION;
}

std::string effective_licence() {
  return "MIT (own sources; linked: METIS and oneTBB under Apache-2.0, others under permissive licences and the LGPL)";
}

std::string version_text() {
  return "thinwall " + thinwall_version() + "\nlicence of this build: " + effective_licence();
}

std::vector<std::pair<std::string, std::string>> component_versions() {
  return {{"thinwall", thinwall_version()},
          {"compiler", "g++ " __VERSION__},
          {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"METIS", fmt::format("{}.{}.{}", METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR)},
          {"oneTBB", fmt::format("{}.{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH)},
          {"HDF5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE)}};
}

}  // namespace thinwall
