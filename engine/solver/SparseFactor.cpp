#include "engine/solver/SparseFactor.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/solver/NodeOrder.hpp"

namespace thinwall {
namespace {

/// Bodies may be solved in threads of their own, the libraries may not. Nested dissection draws from the one random
/// number generator of the process, so that two orders at once become other orders; and Debian's serial OpenBLAS gives
/// two threads the same working memory, so that their factors and solutions, and at times the heap, are ruined.
std::mutex one_at_a_time;

/// To be held while a library works. It opens parallel regions of its own for tiny loops; their threads would only spin
/// against those that render and encode. No active level means that every region runs on the thread that meets it; each
/// thread has a setting of its own.
struct Turn {
  Turn() { omp_set_max_active_levels(0); }
  const std::lock_guard<std::mutex> lock{one_at_a_time};
};

/// Fill-reducing order of the nodes.
std::vector<int> node_order(const BlockPattern& pattern, cholmod_common& common) {
  const Turn turn;
  const int edges = static_cast<int>(pattern.neighbours.size());
  std::vector<int> order(pattern.nodes());
  cholmod_sparse graph{};
  std::vector<int> columns = pattern.neighbour_begin, rows = pattern.neighbours;
  graph.nrow = graph.ncol = pattern.nodes();
  graph.nzmax = edges;
  graph.p = columns.data();
  graph.i = rows.data();
  graph.stype = -1;
  graph.itype = CHOLMOD_INT;
  graph.xtype = CHOLMOD_PATTERN;
  graph.sorted = graph.packed = 1;
  if (edges == 0) {
    std::iota(order.begin(), order.end(), 0);
  } else if (!cholmod_metis(&graph, nullptr, 0, 1, order.data(), &common)) {
    throw std::bad_alloc();
  }
  return order;
}

}  // namespace

struct SparseFactor::Implementation {
  BlockPattern pattern;
  cholmod_common common{};
  cholmod_sparse matrix{};
  cholmod_factor* definite = nullptr;    // supernodal
  cholmod_factor* indefinite = nullptr;  // simplicial, analysed on first need
  cholmod_factor* current = nullptr;     // the one that holds the last factorisation
  cholmod_dense* solution = nullptr;
  cholmod_dense* workspace_y = nullptr;
  cholmod_dense* workspace_e = nullptr;
  std::vector<int> nodes;          // in their order
  std::vector<int> order;          // (unknowns)
  double operations = 0;           // of a supernodal factorisation
  double operations_per_node = 0;  // with the last order that was not taken over

  explicit Implementation(const BlockPattern& the_pattern, const Implementation* before = nullptr)
      : pattern(the_pattern) {
    cholmod_start(&common);
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(pattern.unknowns());
    matrix.nzmax = pattern.nonzeros();
    matrix.p = pattern.column_begin.data();
    matrix.i = pattern.row.data();
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    if (before != nullptr && pattern.singles == 0 && before->pattern.singles == 0) {
      set_order(extended_order(before->pattern, before->nodes, pattern));
      operations_per_node = before->operations_per_node;
      if (operations <= kWorseOrder * operations_per_node * pattern.nodes()) return;
      cholmod_free_factor(&definite, &common);
    }
    set_order(node_order(pattern, common));
    operations_per_node = operations / std::max(1, pattern.nodes());
  }

  void set_order(std::vector<int> the_nodes) {
    nodes = std::move(the_nodes);
    order.clear();
    for (const int node : nodes) {
      for (int c = 0; c < pattern.unknowns_of(node); ++c) order.push_back(pattern.first_unknown(node) + c);
    }
    definite = analyze(CHOLMOD_SUPERNODAL, true);
    operations = common.fl;
  }

  ~Implementation() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&workspace_y, &common);
    cholmod_free_dense(&workspace_e, &common);
    cholmod_free_factor(&definite, &common);
    cholmod_free_factor(&indefinite, &common);
    cholmod_finish(&common);
  }

  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  cholmod_factor* analyze(int kind, bool as_product) {
    common.supernodal = kind;
    common.final_ll = as_product;
    matrix.xtype = CHOLMOD_PATTERN;
    cholmod_factor* factor = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common);
    if (factor == nullptr) throw std::bad_alloc();
    return factor;
  }

  bool factorize(cholmod_factor* factor, std::span<const double> values) {
    assert(static_cast<int>(values.size()) == pattern.nonzeros());
    const Turn turn;
    // The library reads the values only; its interface lacks the const.
    matrix.x = const_cast<double*>(values.data());
    matrix.xtype = CHOLMOD_REAL;
    if (!cholmod_factorize(&matrix, factor, &common) && common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    return common.status == CHOLMOD_OK && factor->minor == factor->n;
  }
};

SparseFactor::SparseFactor(const BlockPattern& pattern) : implementation_(std::make_unique<Implementation>(pattern)) {}
SparseFactor::SparseFactor(const BlockPattern& pattern, const SparseFactor& before)
    : implementation_(std::make_unique<Implementation>(pattern, before.implementation_.get())) {}
SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

bool SparseFactor::factorize(std::span<const double> values) {
  Implementation& own = *implementation_;
  if (!own.factorize(own.definite, values)) return false;
  own.current = own.definite;
  return true;
}

std::optional<int> SparseFactor::factorize_indefinite(std::span<const double> values) {
  Implementation& own = *implementation_;
  if (own.indefinite == nullptr) own.indefinite = own.analyze(CHOLMOD_SIMPLICIAL, false);
  own.common.supernodal = CHOLMOD_SIMPLICIAL;
  own.common.final_ll = 0;
  if (!own.factorize(own.indefinite, values)) return std::nullopt;
  const auto* begin = static_cast<const int*>(own.indefinite->p);
  const auto* entries = static_cast<const double*>(own.indefinite->x);
  int negative = 0;
  for (std::size_t k = 0; k < own.indefinite->n; ++k) {
    const double pivot = entries[begin[k]];  // D stands where the unit diagonal of L would
    if (!std::isfinite(pivot) || pivot == 0) return std::nullopt;
    negative += pivot < 0 ? 1 : 0;
  }
  own.current = own.indefinite;
  return negative;
}

double SparseFactor::operations() const {
  return implementation_->operations;
}

void SparseFactor::solve(Eigen::Ref<Eigen::MatrixXd> right_hand_sides) {
  Implementation& own = *implementation_;
  assert(own.current != nullptr);
  const Turn turn;
  cholmod_dense dense{};
  dense.nrow = right_hand_sides.rows();
  dense.ncol = right_hand_sides.cols();
  dense.d = right_hand_sides.outerStride();
  dense.nzmax = dense.d * dense.ncol;
  dense.x = right_hand_sides.data();
  dense.xtype = CHOLMOD_REAL;
  dense.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_A, own.current, &dense, nullptr, &own.solution, nullptr, &own.workspace_y,
                      &own.workspace_e, &own.common)) {
    throw std::bad_alloc();
  }
  const auto* solved = static_cast<const double*>(own.solution->x);
  for (Eigen::Index column = 0; column < right_hand_sides.cols(); ++column) {
    std::copy_n(solved + column * own.solution->d, right_hand_sides.rows(), right_hand_sides.col(column).data());
  }
}

}  // namespace thinwall
