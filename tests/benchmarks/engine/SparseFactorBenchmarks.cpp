// The sparse factorisation and its solutions beside CHOLMOD's supernodal ones, on the matrices of membranes.

#include <benchmark/benchmark.h>
#include <cholmod.h>
#include <omp.h>

#include <Eigen/Core>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/solver/BlockPattern.hpp"
#include "engine/solver/NodeOrder.hpp"
#include "engine/solver/SparseFactor.hpp"

namespace thinwall {
namespace {

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(80)->Arg(320)->Arg(1280)->Arg(5120)->Arg(20480)->Unit(benchmark::kMicrosecond);
}

/// The matrix of a sphere whose edges are springs, held by weak springs everywhere.
struct Membrane {
  BlockPattern pattern;
  std::vector<double> values;

  explicit Membrane(int triangles) {
    const SurfaceMesh mesh = make_sphere(1, triangles);
    pattern = make_block_pattern(static_cast<int>(mesh.vertices.size()), mesh.triangles);
    values.assign(pattern.nonzeros(), 0);
    for (const Eigen::Vector3i& triangle : mesh.triangles) {
      Eigen::Matrix<double, 9, 9> springs = Eigen::Matrix<double, 9, 9>::Zero();
      for (int k = 0; k < 3; ++k) {
        Eigen::Matrix<double, 9, 1> stretch = Eigen::Matrix<double, 9, 1>::Zero();
        const int next = (k + 1) % 3;
        stretch.segment<3>(3 * k) = (mesh.vertices[triangle[next]] - mesh.vertices[triangle[k]]).normalized();
        stretch.segment<3>(3 * next) = -stretch.segment<3>(3 * k);
        springs += stretch * stretch.transpose();
      }
      add_triangle(triangle_addresses(pattern, triangle), springs, values);
    }
    for (int k = 0; k < pattern.unknowns(); ++k) values[pattern.column_begin[k]] += 0.1;
  }
};

/// The same with the peer's functions.
class Peer {
 public:
  explicit Peer(const Membrane& membrane) : membrane_(membrane) {
    // At its best: threads for its tiny loops would only get into each other's way.
    omp_set_max_active_levels(0);
    cholmod_start(&common_);
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
    common_.postorder = 1;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    const BlockPattern& pattern = membrane_.pattern;
    for (const int node : nested_dissection(pattern)) {
      for (int k = 0; k < 3; ++k) order_.push_back(3 * node + k);
    }
    matrix_.nrow = matrix_.ncol = static_cast<std::size_t>(pattern.unknowns());
    matrix_.nzmax = static_cast<std::size_t>(pattern.nonzeros());
    matrix_.p = membrane_.pattern.column_begin.data();
    matrix_.i = membrane_.pattern.row.data();
    matrix_.x = membrane_.values.data();
    matrix_.stype = -1;
    matrix_.itype = CHOLMOD_INT;
    matrix_.dtype = CHOLMOD_DOUBLE;
    matrix_.xtype = CHOLMOD_REAL;
    matrix_.sorted = matrix_.packed = 1;
    factor_ = cholmod_analyze_p(&matrix_, order_.data(), nullptr, 0, &common_);
  }
  ~Peer() {
    cholmod_free_dense(&solution_, &common_);
    cholmod_free_dense(&y_, &common_);
    cholmod_free_dense(&e_, &common_);
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  void factorize() { cholmod_factorize(&matrix_, factor_, &common_); }

  void solve(Eigen::MatrixXd& right) {
    cholmod_dense dense{};
    dense.nrow = dense.d = static_cast<std::size_t>(right.rows());
    dense.ncol = static_cast<std::size_t>(right.cols());
    dense.nzmax = dense.nrow * dense.ncol;
    dense.x = right.data();
    dense.xtype = CHOLMOD_REAL;
    dense.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, factor_, &dense, nullptr, &solution_, nullptr, &y_, &e_, &common_);
  }

 private:
  Membrane membrane_;
  cholmod_common common_{};
  cholmod_sparse matrix_{};
  std::vector<int> order_;
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *solution_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

Membrane membrane_of(const benchmark::State& state) {
  return Membrane(static_cast<int>(state.range(0)));
}

void SparseFactorize(benchmark::State& state, Precision precision) {
  const Membrane membrane = membrane_of(state);
  SparseFactor factor(membrane.pattern);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorize(membrane.values, false, precision));
  state.counters["operations"] = factor.operations();
}
BENCHMARK_CAPTURE(SparseFactorize, in_double, Precision::kDouble)->Apply(sizes);
BENCHMARK_CAPTURE(SparseFactorize, in_single, Precision::kSingle)->Apply(sizes);

void SparseFactorizeIndefinite(benchmark::State& state) {
  Membrane membrane = membrane_of(state);
  for (int k = 0; k < membrane.pattern.unknowns(); k += 7) membrane.values[membrane.pattern.column_begin[k]] -= 10;
  SparseFactor factor(membrane.pattern);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorize(membrane.values, true));
}
BENCHMARK(SparseFactorizeIndefinite)->Apply(sizes);

void PeerFactorize(benchmark::State& state) {
  Peer peer(membrane_of(state));
  for (auto _ : state) peer.factorize();
}
BENCHMARK(PeerFactorize)->Apply(sizes);

void SparseSolve(benchmark::State& state, int columns, Precision precision) {
  const Membrane membrane = membrane_of(state);
  SparseFactor factor(membrane.pattern);
  factor.factorize(membrane.values, false, precision);
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(membrane.pattern.unknowns(), columns);
  for (auto _ : state) {
    right.setOnes();
    factor.solve(right);
  }
}
BENCHMARK_CAPTURE(SparseSolve, one, 1, Precision::kDouble)->Apply(sizes);
BENCHMARK_CAPTURE(SparseSolve, eight, 8, Precision::kDouble)->Apply(sizes);
BENCHMARK_CAPTURE(SparseSolve, one_in_single, 1, Precision::kSingle)->Apply(sizes);
BENCHMARK_CAPTURE(SparseSolve, eight_in_single, 8, Precision::kSingle)->Apply(sizes);

/// What refinement asks for beside a solution.
void SparseProduct(benchmark::State& state) {
  const Membrane membrane = membrane_of(state);
  SparseFactor factor(membrane.pattern);
  factor.factorize(membrane.values, false, Precision::kSingle);
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(membrane.pattern.unknowns());
  Eigen::VectorXd left = x;
  for (auto _ : state) factor.subtract_product(x, left);
}
BENCHMARK(SparseProduct)->Apply(sizes);

void PeerSolve(benchmark::State& state, int columns) {
  const Membrane membrane = membrane_of(state);
  Peer peer(membrane);
  peer.factorize();
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(membrane.pattern.unknowns(), columns);
  for (auto _ : state) {
    right.setOnes();
    peer.solve(right);
  }
}
BENCHMARK_CAPTURE(PeerSolve, one, 1)->Apply(sizes);
BENCHMARK_CAPTURE(PeerSolve, eight, 8)->Apply(sizes);

void SparseAnalyse(benchmark::State& state) {
  const Membrane membrane = membrane_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(SparseFactor(membrane.pattern).operations());
}
BENCHMARK(SparseAnalyse)->Apply(sizes);

}  // namespace
}  // namespace thinwall
