#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace thinwall {

/// A row of forces.csv.
struct ToolRecord {
  std::string tool;
  std::string phase;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // metres, the tip
  double depth = 0;                                    // metres along the direction since first contact, 0 before
  Eigen::Vector3d force = Eigen::Vector3d::Zero();     // newton, what the tissue does to the tool
  double contact_area = 0;                             // metres^2
};

/// A row of body.csv. Energies in joule; those that are spent or put in are sums since time zero.
struct BodyRecord {
  std::string body;
  double volume = 0;        // metres^3
  double fluid_volume = 0;  // metres^3
  double leaked = 0;        // metres^3
  double pressure = 0;      // pascal
  double open_area = 0;     // metres^2
  double cut_length = 0;    // metres
  double elastic = 0;
  double bending = 0;
  double kinetic = 0;
  double fluid = 0;
  double gravity = 0;
  double contact = 0;
  double viscous = 0;
  double friction = 0;
  double fracture = 0;
  double leak = 0;
  double numerical = 0;
  double jump = 0;
  double tool_work = 0;
  double script_work = 0;
  int newton_iterations = 0;
  double residual = 0;  // newton
};

/// A row of points.csv.
struct PointRecord {
  std::string body;
  std::string point;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();     // metres
  Eigen::Vector3d stress_free = Eigen::Vector3d::Zero();  // metres

  Eigen::Vector3d displacement() const { return position - stress_free; }  // metres
};

/// A row of chambers.csv.
struct ChamberRecord {
  std::string body;
  std::string chamber;
  double volume = 0;        // metres^3
  double fluid_volume = 0;  // metres^3
  double leaked = 0;        // metres^3
  double pressure = 0;      // pascal
};

/// What a step leaves in the records.
struct StepRecord {
  double time = 0;                           // seconds
  std::vector<ToolRecord> tools;             // in the order of the scenario
  std::vector<BodyRecord> bodies;            // in the order of the scenario
  std::vector<PointRecord> points = {};      // in the order of the scenario; not kept in a take
  std::vector<ChamberRecord> chambers = {};  // those with a name, by bodies; not kept in a take
};

}  // namespace thinwall
