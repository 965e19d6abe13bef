#include "engine/solver/SparseFactor.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/solver/EliminationSchedule.hpp"
#include "engine/solver/MultifrontalFactor.hpp"
#include "engine/solver/NodeOrder.hpp"
#include "engine/solver/SupernodeTree.hpp"

namespace thinwall {
namespace {

constexpr int kMostSides = MultifrontalFactor<double>::kMostSides;

/// Numbers of a factor from which on single precision is worth its while, that of some 2 000 triangles: below,
/// refinement costs what it gains.
constexpr std::ptrdiff_t kWorthSinglePrecision = 300'000;

}  // namespace

struct SparseFactor::Implementation {
  int vertices = 0, unknowns = 0, nonzeros = 0;
  NodeGraph graph;
  std::vector<int> nodes;   // in their order
  std::vector<int> parent;  // (nodes), in the elimination tree
  SupernodeTree tree;
  EliminationSchedule schedule;
  std::vector<int> front_at;       // (unknowns), of their places
  double operations_per_node = 0;  // with the last order that was not taken over
  // Made when they are first asked for.
  std::optional<MultifrontalFactor<double>> in_double;
  std::optional<MultifrontalFactor<float>> in_single;
  Precision precision = Precision::kDouble;  // of the last factorisation
  std::vector<double> values;                // (non-zeros), of the last one in single precision

  explicit Implementation(const BlockPattern& pattern, const Implementation* before = nullptr)
      : vertices(pattern.vertices),
        unknowns(pattern.unknowns()),
        nonzeros(pattern.nonzeros()),
        graph(graph_of(pattern)) {
    if (before != nullptr) {
      set_order(
          pattern,
          extended_order(
              {.graph = before->graph, .order = before->nodes, .parent = before->parent, .vertices = before->vertices},
              graph, vertices));
      operations_per_node = before->operations_per_node;
    }
    if (before == nullptr || tree.operations > kWorseOrder * operations_per_node * pattern.nodes()) {
      set_order(pattern, nested_dissection(pattern));
      operations_per_node = tree.operations / std::max(1, pattern.nodes());
    }
    schedule = make_elimination_schedule(tree);
  }

  void set_order(const BlockPattern& pattern, std::vector<int> order) {
    nodes = std::move(order);
    parent = elimination_tree(graph, nodes);
    tree = make_supernode_tree(pattern, graph, nodes, parent);
    front_at.resize(unknowns);
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
      std::fill_n(front_at.begin() + tree.supernodes[s].first, tree.supernodes[s].pivots, s);
    }
  }

  template <typename Number>
  std::optional<int> factorize(std::optional<MultifrontalFactor<Number>>& factor, std::span<const double> matrix,
                               bool may_be_indefinite) {
    if (!factor) factor.emplace(tree, schedule);
    return factor->factorize(matrix, may_be_indefinite);
  }

  bool is_factorised() const {
    return precision == Precision::kDouble ? in_double && in_double->is_factorised()
                                           : in_single && in_single->is_factorised();
  }

  /// from -= A x of a node's columns, which begin at `column` with the diagonal and go on with its later neighbours;
  /// gives where the next node's begin.
  template <int columns>
  const double* subtract_columns(int node, const double* column, const Eigen::VectorXd& x,
                                 Eigen::VectorXd& from) const {
    const int first = first_unknown(node);
    const std::span<const int> around = graph.around(node);
    const auto later = std::ranges::upper_bound(around, node);
    for (int c = 0; c < columns; ++c) {
      const double own = x[first + c];
      double sum = *column++ * own;
      const auto take = [&](int row) {
        sum += *column * x[row];
        from[row] -= *column++ * own;
      };
      for (int row = c + 1; row < columns; ++row) take(first + row);
      for (auto other = later; other != around.end(); ++other) {
        const int begin = first_unknown(*other), end = begin + (*other < vertices ? 3 : 1);
        for (int row = begin; row < end; ++row) take(row);
      }
      from[first + c] -= sum;
    }
    return column;
  }

  int first_unknown(int node) const { return node < vertices ? 3 * node : 2 * vertices + node; }

  void subtract_product(const Eigen::VectorXd& x, Eigen::VectorXd& from) const {
    const double* column = values.data();
    for (int node = 0; node < graph.nodes(); ++node) {
      column =
          node < vertices ? subtract_columns<3>(node, column, x, from) : subtract_columns<1>(node, column, x, from);
    }
    assert(column == values.data() + nonzeros);
  }

  std::vector<int> fronts_above(std::span<const int> of_unknowns) const {
    std::vector<char> is_above(tree.supernodes.size(), 0);
    for (const int unknown : of_unknowns) {
      for (int s = front_at[tree.place[unknown]]; s >= 0 && !is_above[s]; s = tree.supernodes[s].parent)
        is_above[s] = 1;
    }
    std::vector<int> fronts;
    for (int s = 0; s < static_cast<int>(is_above.size()); ++s) {
      if (is_above[s]) fronts.push_back(s);
    }
    return fronts;
  }
};

SparseFactor::SparseFactor(const BlockPattern& pattern) : implementation_(std::make_unique<Implementation>(pattern)) {}
SparseFactor::SparseFactor(const BlockPattern& pattern, const SparseFactor& before)
    : implementation_(std::make_unique<Implementation>(pattern, before.implementation_.get())) {}
SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

std::optional<int> SparseFactor::factorize(std::span<const double> values, bool may_be_indefinite,
                                           Precision precision) {
  Implementation& own = *implementation_;
  assert(static_cast<int>(values.size()) == own.nonzeros);
  own.precision = precision;
  if (precision == Precision::kDouble) return own.factorize(own.in_double, values, may_be_indefinite);
  own.values.assign(values.begin(), values.end());
  return own.factorize(own.in_single, values, may_be_indefinite);
}

Precision SparseFactor::precision() const {
  return implementation_->precision;
}

bool SparseFactor::is_worth_single_precision() const {
  return implementation_->tree.factor_size >= kWorthSinglePrecision;
}

void SparseFactor::subtract_product(const Eigen::VectorXd& x, Eigen::VectorXd& from) const {
  assert(implementation_->precision == Precision::kSingle);
  implementation_->subtract_product(x, from);
}

double SparseFactor::operations() const {
  return implementation_->tree.operations;
}

void SparseFactor::solve(Eigen::Ref<Eigen::MatrixXd> right_hand_sides) {
  Implementation& own = *implementation_;
  assert(own.is_factorised());
  own.precision == Precision::kDouble ? own.in_double->solve(right_hand_sides) : own.in_single->solve(right_hand_sides);
}

double SparseFactor::cost_of(Eigen::Index right_hand_sides) {
  constexpr double kCostOfFour = 2, kCostOfEight = 3.5;
  const Eigen::Index eights = right_hand_sides / kMostSides, rest = right_hand_sides % kMostSides;
  const double cost_of_rest = rest > 4 ? kCostOfEight : rest > 2 ? kCostOfFour : static_cast<double>(rest);
  return kCostOfEight * static_cast<double>(eights) + cost_of_rest;
}

SparseFactor::Part SparseFactor::part_of(std::vector<int> unknowns) const {
  std::vector<int> fronts = implementation_->fronts_above(unknowns);
  return {.unknowns = std::move(unknowns), .fronts = std::move(fronts)};
}

void SparseFactor::solve_part(const Part& part, Eigen::Ref<Eigen::VectorXd> right_hand_side) {
  Implementation& own = *implementation_;
  assert(own.is_factorised() && part.unknowns.size() == static_cast<std::size_t>(right_hand_side.size()));
  own.precision == Precision::kDouble ? own.in_double->solve_part(part.unknowns, part.fronts, right_hand_side)
                                      : own.in_single->solve_part(part.unknowns, part.fronts, right_hand_side);
}

}  // namespace thinwall
