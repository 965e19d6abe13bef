#include "studio/director/StateDigest.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace thinwall {

std::string state_digest(std::span<const std::unique_ptr<Body>> bodies) {
  XXH3_state_t* state = XXH3_createState();
  XXH3_128bits_reset(state);
  const auto add = [&](const double* values, Eigen::Index count) {
    XXH3_128bits_update(state, values, static_cast<std::size_t>(count) * sizeof(double));
  };
  for (const auto& body : bodies) {
    const BodyState& own = body->state();
    add(own.equilibrium.position.data(), own.equilibrium.position.size());
    add(own.velocity.data(), own.velocity.size());
    add(own.equilibrium.pressure.data(), own.equilibrium.pressure.size());
    for (const ToolContact& contact : own.contacts) add(contact.force.data(), 3);
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state);
  XXH3_freeState(state);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace thinwall
