#include "engine/equilibrium/FrictionMixing.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace thinwall {
namespace {

/// Turns that are looked back on: about as many as there are places that share the load of jaws anew each time. With 8
/// jaws that hold a taut shell took four times as many iterations.
constexpr std::size_t kMostTurns = 12;

/// Part of a change that others do not tell below which it is left out: where places stick and slide in turn, what sets
/// two turns apart by less than that is chance.
constexpr double kSameChange = 1e-2;

}  // namespace

std::vector<FrictionMixing::Press> FrictionMixing::pushes(std::span<const FrictionContact> contacts) {
  std::vector<Press> pushes;
  for (const FrictionContact& contact : contacts) {
    pushes.push_back({.place = {contact.solid, contact.site}, .push = contact.potential.limit * contact.normal});
  }
  return pushes;
}

void FrictionMixing::note(std::span<const FrictionContact> given, std::span<const FrictionContact> asked) {
  turns_.push_back({.given = pushes(given), .asked = pushes(asked)});
  if (turns_.size() > kMostTurns) turns_.erase(turns_.begin());
  places_.clear();
  for (const Turn& turn : turns_) {
    for (const Press& press : turn.given) places_.push_back(press.place);
    for (const Press& press : turn.asked) places_.push_back(press.place);
  }
  std::ranges::sort(places_);
  const auto same = std::ranges::unique(places_);
  places_.erase(same.begin(), same.end());
  const Eigen::VectorXd change = at_places(turns_.back().asked) - at_places(turns_.back().given);
  missed_ = 0;
  for (Eigen::Index k = 0; k < change.size(); k += 3) missed_ += change.segment<3>(k).norm();
}

Eigen::VectorXd FrictionMixing::at_places(std::span<const Press> pushes) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(places_.size()));
  auto place = places_.begin();
  for (const Press& press : pushes) {
    place = std::lower_bound(place, places_.end(), press.place);
    all.segment<3>(3 * (place - places_.begin())) = press.push;
  }
  return all;
}

Eigen::VectorXd FrictionMixing::mixed(double part) const {
  const Eigen::VectorXd given = at_places(turns_.back().given);
  const Eigen::VectorXd change = at_places(turns_.back().asked) - given;
  const auto count = static_cast<Eigen::Index>(turns_.size()) - 1;
  if (count == 0) return given + part * change;
  Eigen::MatrixXd of_given(given.size(), count), of_change(given.size(), count);  // from turn to turn
  for (Eigen::Index k = 0; k < count; ++k) {
    const Turn &before = turns_[k], &after = turns_[k + 1];
    of_given.col(k) = at_places(after.given) - at_places(before.given);
    of_change.col(k) = at_places(after.asked) - at_places(before.asked) - of_given.col(k);
    // The last turns tell most, however small their changes have become.
    const double size = of_change.col(k).norm();
    if (size == 0) continue;
    of_given.col(k) /= size;
    of_change.col(k) /= size;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor;
  factor.setThreshold(kSameChange);
  factor.compute(of_change);
  const Eigen::VectorXd shares = factor.solve(change);
  return given - of_given * shares + part * (change - of_change * shares);
}

std::vector<FrictionContact> FrictionMixing::next(std::span<const FrictionContact> given,
                                                  std::span<const FrictionContact> asked, double part) const {
  const Eigen::VectorXd wanted = mixed(part);
  std::vector<FrictionContact> contacts;
  auto old = given.begin(), fresh = asked.begin();
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const auto is_here = [&](const FrictionContact& contact) {
      return Place{contact.solid, contact.site} == places_[k];
    };
    const bool was_given = old != given.end() && is_here(*old), is_asked = fresh != asked.end() && is_here(*fresh);
    if (!was_given && !is_asked) continue;
    FrictionContact contact = is_asked ? *fresh : *old;
    if (was_given) ++old;
    if (is_asked) ++fresh;
    const Eigen::Vector3d push = wanted.segment<3>(3 * static_cast<Eigen::Index>(k));
    // A mixture may ask a place that lets go to pull.
    if (push.dot(contact.normal) <= 0) continue;
    contact.potential.limit = push.norm();
    contact.normal = push.normalized();
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace thinwall
