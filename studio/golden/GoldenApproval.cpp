#include "studio/golden/GoldenApproval.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/image/WholeFile.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "studio/golden/ApprovalFile.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kApprovalVersion = 1;
constexpr const char* kFile = "approval.json";

std::optional<std::vector<std::string>> names_in(const ApprovalValue& golden, const char* key) {
  if (!golden.has(key)) return std::nullopt;
  return golden.texts(key);
}

GoldenApproval to_approval(const ApprovalValue& golden) {
  return {.at = golden.number("at_s"),
          .driver = golden.text("driver"),
          .image = golden.text("image"),
          .state = golden.text("state"),
          .state_digest = golden.text("state_digest"),
          .who = golden.text("who"),
          .why = golden.text("why"),
          .history = golden.text_if_there("history"),
          .scene_hash = golden.text_if_there("scene_hash"),
          .overlay = golden.has("overlay") ? golden.dump("overlay") : "",
          .second_state = golden.text_if_there("second_state"),
          .second_state_digest = golden.text_if_there("second_state_digest"),
          .picture_hash = golden.text_if_there("picture_hash"),
          .files = golden.has("files") ? golden.dump("files") : "",
          .set_aside = names_in(golden, "set_aside"),
          .second_set_aside = names_in(golden, "second_set_aside")};
}

}  // namespace

GoldenError damaged_golden(const std::string& what) {
  return GoldenError(what + "; restore it from version control, or remove the scenario's folder and approve anew");
}

std::string lost_file(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (name.empty() || std::filesystem::exists(folder / name)) continue;
    return (folder / name).string() + " is missing; restore it from version control, or approve anew";
  }
  return "";
}

GoldenError exchanged_picture(const std::filesystem::path& file) {
  return damaged_golden(file.string() + ": is not the picture that was approved");
}

bool is_approved_state(const TakeReader& state, const std::string& digest) {
  return state.ending().state_digest == digest;
}

std::vector<GoldenApproval> read_approvals(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kFile;
  if (!std::filesystem::exists(file)) return {};
  const ApprovalFile approved(file, "approval_version", kApprovalVersion);
  std::vector<GoldenApproval> approvals;
  for (const ApprovalValue& golden : approved.root().list("goldens")) approvals.push_back(to_approval(golden));
  return approvals;
}

void write_approvals(const std::filesystem::path& folder, const std::vector<GoldenApproval>& approvals) {
  Json goldens = Json::array();
  for (const GoldenApproval& approval : approvals) {
    goldens.push_back({{"at_s", approval.at},
                       {"driver", approval.driver},
                       {"image", approval.image},
                       {"state", approval.state},
                       {"state_digest", approval.state_digest},
                       {"who", approval.who},
                       {"why", approval.why}});
    Json& golden = goldens.back();
    if (!approval.second_state.empty()) {
      golden["second_state"] = approval.second_state;
      golden["second_state_digest"] = approval.second_state_digest;
    }
    if (!approval.history.empty()) golden["history"] = approval.history;
    if (!approval.picture_hash.empty()) golden["picture_hash"] = approval.picture_hash;
    if (!approval.scene_hash.empty()) golden["scene_hash"] = approval.scene_hash;
    if (!approval.files.empty()) golden["files"] = Json::parse(approval.files);
    if (!approval.overlay.empty()) golden["overlay"] = Json::parse(approval.overlay);
    if (approval.set_aside) golden["set_aside"] = *approval.set_aside;
    if (approval.second_set_aside) golden["second_set_aside"] = *approval.second_set_aside;
  }
  const Json json = {{"approval_version", kApprovalVersion}, {"goldens", goldens}};
  write_whole_file(folder / kFile, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

const GoldenApproval* find_approval(const std::vector<GoldenApproval>& approvals, double at,
                                    const std::string& driver) {
  const GoldenApproval* found = nullptr;
  for (const GoldenApproval& approval : approvals) {
    if (std::abs(approval.at - at) > kSameTime) continue;
    if (approval.driver == driver) return &approval;
    found = &approval;
  }
  return found;
}

std::string golden_stem(double at, const std::string& driver) {
  return fmt::format("at_{:.9g}s.{:08x}", at, XXH3_64bits(driver.data(), driver.size()) & 0xffffffffU);
}

}  // namespace thinwall
