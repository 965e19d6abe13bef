#include "studio/organs/generator/ImplicitBody.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace thinwall {
namespace {

class SweptSphere {
 public:
  explicit SweptSphere(const std::vector<AxisPoint>& control_points) {
    assert(control_points.size() >= 2);
    // A control point three times over is a point of the spline.
    control_.assign(2, control_points.front());
    control_.insert(control_.end(), control_points.begin(), control_points.end());
    control_.insert(control_.end(), 2, control_points.back());
    spans_ = static_cast<int>(control_.size()) - 3;
    for (int i = 0; i <= spans_ * kSamplesPerSpan; ++i) {
      samples_.push_back(at(static_cast<double>(i) / kSamplesPerSpan));
    }
  }

  FieldValue operator()(const Eigen::Vector3d& point) const {
    int nearest = 0;
    double least = distance(samples_[0], point);
    for (int i = 1; i < static_cast<int>(samples_.size()); ++i) {
      const double here = distance(samples_[i], point);
      if (here < least) {
        least = here;
        nearest = i;
      }
    }
    const AxisPoint ball = refine(point, nearest);
    const Eigen::Vector3d reach = point - ball.position;
    const double length = reach.norm();
    // The nearest sphere moves with the point, but at the minimum that changes nothing to first order.
    const Eigen::Vector3d outwards = length > 0 ? Eigen::Vector3d(reach / length) : Eigen::Vector3d::UnitZ();
    return {length - ball.radius, outwards};
  }

 private:
  static constexpr int kSamplesPerSpan = 4;

  static double distance(const AxisPoint& ball, const Eigen::Vector3d& point) {
    return (point - ball.position).norm() - ball.radius;
  }

  AxisPoint at(double parameter) const {
    const int span = std::min(static_cast<int>(parameter), spans_ - 1);
    const double t = parameter - span;
    const double s = 1 - t;
    const double weights[] = {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
                              t * t * t / 6};
    AxisPoint result;
    for (int k = 0; k < 4; ++k) {
      result.position += weights[k] * control_[span + k].position;
      result.radius += weights[k] * control_[span + k].radius;
    }
    return result;
  }

  /// Ternary search between the neighbours of the nearest sample.
  AxisPoint refine(const Eigen::Vector3d& point, int nearest) const {
    double low = static_cast<double>(std::max(nearest - 1, 0)) / kSamplesPerSpan;
    double high = static_cast<double>(std::min(nearest + 1, spans_ * kSamplesPerSpan)) / kSamplesPerSpan;
    for (int step = 0; step < 20; ++step) {  // to 3e-4 of the way between samples
      const double a = low + (high - low) / 3;
      const double b = high - (high - low) / 3;
      if (distance(at(a), point) < distance(at(b), point)) {
        high = b;
      } else {
        low = a;
      }
    }
    return at((low + high) / 2);
  }

  std::vector<AxisPoint> control_;
  std::vector<AxisPoint> samples_;
  int spans_ = 0;
};

/// sign 1: union; -1: intersection, which is the union of the outsides.
FieldValue blended(const FieldValue& a, const FieldValue& b, double blend, double sign) {
  const bool a_first = sign * a.value <= sign * b.value;
  const FieldValue& low = a_first ? a : b;
  const FieldValue& high = a_first ? b : a;
  const double h = std::max(1 - std::abs(high.value - low.value) / blend, 0.0);
  return {low.value - sign * blend * h * h * h / 6, (1 - h * h / 2) * low.gradient + h * h / 2 * high.gradient};
}

}  // namespace

ImplicitBody sphere_body(const Eigen::Vector3d& centre, double radius) {
  return [=](const Eigen::Vector3d& point) -> FieldValue {
    const Eigen::Vector3d reach = point - centre;
    const double length = reach.norm();
    return {length - radius, length > 0 ? Eigen::Vector3d(reach / length) : Eigen::Vector3d::UnitZ()};
  };
}

ImplicitBody half_space_body(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  return [=](const Eigen::Vector3d& where) -> FieldValue { return {(where - point).dot(normal), normal}; };
}

ImplicitBody swept_sphere_body(const std::vector<AxisPoint>& control_points) {
  return SweptSphere(control_points);
}

ImplicitBody smooth_union(ImplicitBody a, ImplicitBody b, double blend) {
  return [a = std::move(a), b = std::move(b), blend](const Eigen::Vector3d& point) {
    return blended(a(point), b(point), blend, 1);
  };
}

ImplicitBody smooth_intersection(ImplicitBody a, ImplicitBody b, double blend) {
  return [a = std::move(a), b = std::move(b), blend](const Eigen::Vector3d& point) {
    return blended(a(point), b(point), blend, -1);
  };
}

ImplicitBody outside_of(ImplicitBody body) {
  return [body = std::move(body)](const Eigen::Vector3d& point) -> FieldValue {
    const FieldValue field = body(point);
    return {-field.value, -field.gradient};
  };
}

ImplicitBody stretched_body(ImplicitBody body, const Eigen::Vector3d& factors) {
  return [body = std::move(body), factors, least = factors.minCoeff()](const Eigen::Vector3d& point) -> FieldValue {
    const FieldValue field = body(point.cwiseQuotient(factors));
    return {least * field.value, least * field.gradient.cwiseQuotient(factors)};
  };
}

Eigen::Vector3d project_to_surface(const ImplicitBody& body, Eigen::Vector3d point) {
  for (int step = 0; step < 8; ++step) {
    const FieldValue field = body(point);
    const double slope = field.gradient.squaredNorm();
    if (slope < 1e-12) break;  // on the axis, where there is no way out to prefer
    point -= field.value / slope * field.gradient;
    if (std::abs(field.value) < 1e-9) break;  // a nanometre
  }
  return point;
}

SurfaceToFollow surface_of(const ImplicitBody& body) {
  return {.project = [&body](const Eigen::Vector3d& point,
                             const Eigen::Vector3d&) { return project_to_surface(body, point); },
          .normal = [&body](const Eigen::Vector3d& point, const Eigen::Vector3d&) -> Eigen::Vector3d {
            return body(point).gradient.normalized();
          }};
}

}  // namespace thinwall
