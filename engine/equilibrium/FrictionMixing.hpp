#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/equilibrium/FrictionContact.hpp"

namespace thinwall {

/// Finds the friction that a solution is found with and asks for again: a fixed point. To go on with what the last
/// solution asked for ends where that answers by less than it is changed by; where a wall is held by large friction at
/// a few places it answers by more, and their shares go to and fro without end. So what changes of the last few turns
/// have done is told (Anderson 1965; Walker and Ni 2011): the next solution begins with that mixture of them whose
/// change is least, and goes on from there with the change that is left.
class FrictionMixing {
 public:
  /// What a solution was found with, and what it asks for; both in the order of solids and sites.
  void note(std::span<const FrictionContact> given, std::span<const FrictionContact> asked);
  /// Newton, by which both differ in the last turn: in limits and normals, added up over all places.
  double missed() const { return missed_; }
  /// What the next solution is to be found with: limits and normals, all else as the last solution asked for, or as it
  /// was given where it asks for none. `part`: of the change that no mixture takes away.
  std::vector<FrictionContact> next(std::span<const FrictionContact> given, std::span<const FrictionContact> asked,
                                    double part) const;

 private:
  struct Place {
    int solid = 0, site = 0;
    auto operator<=>(const Place&) const = default;
  };
  struct Press {
    Place place;
    Eigen::Vector3d push = Eigen::Vector3d::Zero();  // newton, limit times normal
  };
  struct Turn {
    std::vector<Press> given, asked;
  };

  static std::vector<Press> pushes(std::span<const FrictionContact> contacts);
  /// (3 places), newton. `pushes`: in order, of some of these places.
  Eigen::VectorXd at_places(std::span<const Press> pushes) const;
  /// (3 places), newton.
  Eigen::VectorXd mixed(double part) const;

  std::vector<Turn> turns_;    // the last ones, oldest first
  std::vector<Place> places_;  // of all these turns, ascending
  double missed_ = 0;
};

}  // namespace thinwall
