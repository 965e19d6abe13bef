#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/Body.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "studio/director/DirectedTool.hpp"
#include "studio/record/StepRecord.hpp"

namespace thinwall {

/// The part of a snapshot that stays while no cut changes a body.
std::shared_ptr<const SnapshotTopology> snapshot_topology(const BodyModel& model);

/// The same after a cut that ends at `time` (seconds), with the times at which vertices came to lie at a cut; `before`:
/// what was there before it.
std::shared_ptr<const SnapshotTopology> snapshot_topology_after_cut(const BodyModel& model,
                                                                    const SnapshotTopology& before, double time);

/// The surface of a body as it is now, with the fields `contact_pressure` (Pa, vertices), and
/// `largest_principal_stress` and `smallest_principal_stress` (Pa, triangles; see Body::principal_stress), these to one
/// part in 16 384.
SnapshotSurface snapshot_surface(const Body& body, std::shared_ptr<const SnapshotTopology> topology);

/// A tool with what the record says of it.
SnapshotTool snapshot_tool(const ToolDefinition& tool, const ToolPose& pose, const ToolRecord& record);

/// Pressure, volume, fluid in it and fluid that has run out of a body, named `BODY.pressure`, `BODY.volume`,
/// `BODY.fluid_volume` and `BODY.leaked`.
void add_scalars(const Body& body, std::vector<SnapshotScalar>& scalars);

/// A row of forces.csv: the tool as it is, and what all bodies together do to it. A tool that touches holds where its
/// clips leave it idle, and is in contact where they only let it approach.
ToolRecord tool_record(const std::string& name, const DirectedTool& tool,
                       std::span<const std::unique_ptr<Body>> bodies);

/// A row of body.csv.
BodyRecord body_record(const Body& body);

/// The rows of chambers.csv of a body: of its chambers that have a name.
std::vector<ChamberRecord> chamber_records(const Body& body);

}  // namespace thinwall
