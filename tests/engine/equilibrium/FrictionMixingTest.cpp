// Friction that a solution is found with and asks for again, on maps whose fixed point is known.

#include "engine/equilibrium/FrictionMixing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace thinwall {
namespace {

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

FrictionContact contact_at(int site, double limit, const Eigen::Vector3d& normal = kUp) {
  FrictionContact contact{.site = site, .normal = normal};
  contact.potential.limit = limit;
  return contact;
}

using Contacts = std::vector<FrictionContact>;

double limit_at(const Contacts& contacts, int site) {
  const auto found = std::ranges::find(contacts, site, &FrictionContact::site);
  return found == contacts.end() ? 0 : found->potential.limit;
}

/// Contacts after so many turns with what each one asks for.
Contacts after(int turns, Contacts given, const std::function<Contacts(const Contacts&)>& asked_for) {
  FrictionMixing mixing;
  for (int turn = 0; turn < turns; ++turn) {
    const Contacts asked = asked_for(given);
    mixing.note(given, asked);
    given = mixing.next(given, asked, 1);
  }
  return given;
}

/// What two places share: each asks for 3 N and so many times what the other has less than that.
Contacts shares(const Contacts& given, double gain) {
  return {contact_at(0, 3 - gain * (limit_at(given, 1) - 3)), contact_at(1, 3 - gain * (limit_at(given, 0) - 3))};
}

TEST(FrictionMixing, BeginsWithWhatTheFirstSolutionAskedFor) {
  FrictionMixing mixing;
  const Contacts given = {contact_at(0, 1)}, asked = {contact_at(0, 2), contact_at(4, 0.5)};
  mixing.note(given, asked);
  EXPECT_DOUBLE_EQ(mixing.missed(), 1.5);
  const Contacts next = mixing.next(given, asked, 1);
  ASSERT_EQ(next.size(), 2u);
  EXPECT_DOUBLE_EQ(limit_at(next, 0), 2);
  EXPECT_DOUBLE_EQ(limit_at(next, 4), 0.5);
}

TEST(FrictionMixing, FindsWhatAnswersByMoreThanItIsChangedBy) {
  // With a gain of 1.3 what two places ask for in turn goes away from their balance by that each time. A straight map
  // of two unknowns is known after as many changes: three turns, and one that goes there.
  const auto asked_for = [](const Contacts& given) { return shares(given, 1.3); };
  const Contacts found = after(4, {contact_at(0, 3.5), contact_at(1, 2.8)}, asked_for);
  EXPECT_NEAR(limit_at(found, 0), 3, 1e-9);
  EXPECT_NEAR(limit_at(found, 1), 3, 1e-9);
}

TEST(FrictionMixing, FindsWhatCreepsThere) {
  // With 0.99 each turn asks for a hundredth of the way.
  const auto asked_for = [](const Contacts& given) { return shares(given, -0.99); };
  const Contacts found = after(4, {contact_at(0, 3.5), contact_at(1, 2.8)}, asked_for);
  EXPECT_NEAR(limit_at(found, 0), 3, 1e-9);
  EXPECT_NEAR(limit_at(found, 1), 3, 1e-9);
}

TEST(FrictionMixing, FindsNormalsThatTurnToAndFro) {
  // A wall rolls on a corner: a slope to one side asks for 1.5 of it to the other.
  const auto asked_for = [](const Contacts& given) -> Contacts {
    const Eigen::Vector3d push = given[0].potential.limit * given[0].normal;
    const Eigen::Vector3d asked(0.1 - 1.5 * (push.x() - 0.1), 0, 2);
    return {contact_at(0, asked.norm(), asked.normalized())};
  };
  const Contacts found = after(3, {contact_at(0, 2, Eigen::Vector3d(0.3, 0, 1).normalized())}, asked_for);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].potential.limit * found[0].normal - Eigen::Vector3d(0.1, 0, 2)).norm(), 1e-9);
}

TEST(FrictionMixing, TakesOffWhatWouldPull) {
  // The second place is asked for while the first has less than 1 N, which it has not at the fixed point, 2 N.
  const auto asked_for = [](const Contacts& given) -> Contacts {
    const double first = limit_at(given, 0);
    Contacts asked = {contact_at(0, 2 + 0.4 * (first - 2))};
    if (first < 1) asked.push_back(contact_at(1, 1 - first));
    return asked;
  };
  const Contacts found = after(6, {contact_at(0, 0.2)}, asked_for);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].site, 0);
  EXPECT_NEAR(found[0].potential.limit, 2, 1e-9);
}

}  // namespace
}  // namespace thinwall
