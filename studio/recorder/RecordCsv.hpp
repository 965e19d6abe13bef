#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "studio/record/StepRecord.hpp"
#include "studio/recorder/UnfinishedText.hpp"

namespace thinwall {

/// The first line of forces.csv, body.csv, points.csv and chambers.csv, without line end.
std::string forces_csv_header();
std::string body_csv_header();
std::string points_csv_header();
std::string chambers_csv_header();

/// The lines of a step, one for each tool, body, recorded point or named chamber. Numbers are the shortest that read
/// back to the same bits. Throws SimulationFailure when one is not finite: no such number gets into a file.
std::string forces_csv_rows(const StepRecord& record);
std::string body_csv_rows(const StepRecord& record);
std::string points_csv_rows(const StepRecord& record);
std::string chambers_csv_rows(const StepRecord& record);

/// forces.csv and body.csv of a run, and points.csv and chambers.csv when the first record has such rows.
class RecordCsv {
 public:
  /// Throws PictureFailure when the files cannot be made in `folder`.
  explicit RecordCsv(const std::filesystem::path& folder);
  void write(const StepRecord& record);
  /// Gives the files their names. Throws PictureFailure.
  void finish();

 private:
  UnfinishedText forces_;
  UnfinishedText body_;
  /// A table that is there only where it has rows.
  struct Table {
    std::filesystem::path file;
    std::string header;
    std::optional<UnfinishedText> text = {};
    void write(const std::string& rows);
  };
  Table points_, chambers_;
};

}  // namespace thinwall
