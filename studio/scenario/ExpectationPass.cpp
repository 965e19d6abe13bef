#include "studio/scenario/ExpectationPass.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "studio/scenario/ClipTimes.hpp"
#include "studio/scenario/NameCheck.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/ExpectationQuantity.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::array kSubjects = {ExpectationSubject::kTool, ExpectationSubject::kBody, ExpectationSubject::kPoint};

NameChoice choice_of_subjects(const CheckedValue& root, ExpectationSubject subject) {
  if (subject == ExpectationSubject::kBody) return choice_of_bodies(root);
  if (subject == ExpectationSubject::kTool) return choice_of(names_in(root, "tools"));
  const CheckedValue* record = root.find("record");
  return record == nullptr ? NameChoice{} : choice_of(names_in(*record, "points"));
}

class ExpectationChecker {
 public:
  ExpectationChecker(CheckedValue& value, std::string path, Diagnostics& diagnostics)
      : value_(value), path_(std::move(path)), diagnostics_(diagnostics) {}

  void check(CheckedValue& root, std::optional<double> end) {
    if (const CheckedValue* word = value_.find("quantity")) {
      word_ = word->text;
      quantity_ = find_expectation_quantity(word_);
      check_subject(root);
      if (is_of_chambers()) check_chamber(root);
      check_kind_of_time();
    } else {
      check_names(root);
      check_chamber(root);
    }
    check_times(end);
    check_bounds();
  }

 private:
  void error(const CheckedValue& value, std::string_view key, const std::string& message) {
    diagnostics_.error(value.location, key.empty() ? path_ : member_path(path_, std::string(key)), message);
  }

  void warning(const CheckedValue& value, std::string_view key, const std::string& message) {
    diagnostics_.warning(value.location, member_path(path_, std::string(key)), message);
  }

  void check_subject(CheckedValue& root) {
    const std::string own(subject_word(quantity_.measured->subject));
    for (const ExpectationSubject subject : kSubjects) {
      const std::string_view key = subject_word(subject);
      const CheckedValue* given = value_.find(key);
      if (given == nullptr || key == own) continue;
      error(*given, key, in_backticks(word_) + " is measured of a " + own + ", write " + in_backticks(own));
    }
    resolve_name(value_, own, choice_of_subjects(root, quantity_.measured->subject), path_, diagnostics_);
  }

  /// Where it is not known of which of them the quantity is: those that are given.
  void check_names(CheckedValue& root) {
    for (const ExpectationSubject subject : kSubjects) {
      const std::string key(subject_word(subject));
      if (value_.find(key) != nullptr) {
        resolve_name(value_, key, choice_of_subjects(root, subject), path_, diagnostics_);
      }
    }
  }

  bool is_of_chambers() {
    const CheckedValue* chamber = value_.find("chamber");
    if (chamber == nullptr || quantity_.measured->is_of_chambers) return true;
    error(*chamber, "chamber", in_backticks(word_) + " is measured of no chamber; leave it out");
    return false;
  }

  void check_chamber(CheckedValue& root) {
    const CheckedValue* body = value_.find("body");
    if (value_.find("chamber") == nullptr) return;
    const CheckedValue* bodies = root.find("bodies");
    const CheckedValue* named = bodies == nullptr || body == nullptr ? nullptr : bodies->find(body->text);
    const CheckedValue* contents = named == nullptr ? nullptr : named->find("contents");
    if (contents == nullptr) return;
    resolve_name(value_, "chamber", choice_of(names_in(*contents, "chambers")), path_, diagnostics_);
  }

  /// Which of `at`, `from` and `until` belong to the quantity.
  void check_kind_of_time() {
    const bool has_moment = quantity_.reduction == Reduction::kMoment;
    const bool has_span = !has_moment && quantity_.reduction != Reduction::kFinal;
    const CheckedValue* at = value_.find("at");
    if (has_moment && at == nullptr && !value_.has_wrong("at")) {
      error(value_, "",
            "`at` is missing: the time that " + in_backticks(word_) + " is taken at; or write " +
                in_backticks("final_" + word_) + " or " + in_backticks("peak_" + word_));
    }
    if (!has_moment && at != nullptr) error(*at, "at", in_backticks(word_) + " takes no `at`");
    for (const std::string_view key : {"from", "until"}) {
      const CheckedValue* given = value_.find(key);
      if (!has_span && given != nullptr) error(*given, key, in_backticks(word_) + " takes no " + in_backticks(key));
    }
  }

  void check_times(std::optional<double> end) {
    const CheckedValue* from = value_.find("from");
    const CheckedValue* until = value_.find("until");
    if (from != nullptr && until != nullptr && from->number > until->number) {
      error(*until, "until", "it ends before it begins at " + format_like(from->number, "1 s"));
    }
    for (const std::string_view key : {"at", "from", "until"}) {
      const CheckedValue* given = value_.find(key);
      if (end && given != nullptr && given->number > *end) {
        error(*given, key, "the timeline ends at " + format_like(*end, "1 s"));
      }
    }
  }

  void check_bounds() {
    const CheckedValue* within = value_.find("within");
    const CheckedValue* expected = value_.find("value");
    CheckedValue* tolerance = value_.find("tolerance");
    if (value_.has_wrong("within") || value_.has_wrong("value") || value_.has_wrong("tolerance")) return;
    if ((within == nullptr) == (expected == nullptr)) {
      error(value_, "", "write either `within`, or `value` and `tolerance`");
    } else if (quantity_.measured == nullptr) {
      return;  // the dimension of the bounds is not known
    } else if (within != nullptr) {
      check_range(*within, tolerance);
    } else {
      check_tolerance(*expected, tolerance);
    }
  }

  void check_range(const CheckedValue& within, const CheckedValue* tolerance) {
    if (tolerance != nullptr) error(*tolerance, "tolerance", "it belongs to `value`, not to `within`");
    bool is_right = true;
    for (const CheckedValue& bound : within.items) is_right = has_dimension(bound, "within") && is_right;
    if (is_right && within.items[0].number > within.items[1].number) {
      error(within, "within", "the first bound is larger than the second");
    }
  }

  /// Makes a tolerance that is a part of the value one in its unit.
  void check_tolerance(const CheckedValue& expected, CheckedValue* tolerance) {
    const bool is_right = has_dimension(expected, "value");
    if (tolerance == nullptr) {
      error(value_, "", "`tolerance` is missing: the allowed difference from `value`, e.g. 1 %");
      return;
    }
    if (tolerance->number < 0) error(*tolerance, "tolerance", "it must be at least 0");
    if (tolerance->dimension != kDimensionless) {
      has_dimension(*tolerance, "tolerance");
    } else if (is_right && expected.number == 0 && tolerance->number != 0) {
      error(*tolerance, "tolerance", "a part of 0 is nothing; write it in the unit of the quantity");
    } else {
      if (tolerance->number > 1) {
        warning(*tolerance, "tolerance",
                "is " + format_like(tolerance->number, "1") +
                    " times `value`, so that its sign does not matter; a part "
                    "is written like `5 %` or 0.05, a difference in the unit of the quantity");
      }
      tolerance->number *= std::abs(expected.number);
      tolerance->dimension = quantity_.measured->dimension;
    }
  }

  bool has_dimension(const CheckedValue& bound, std::string_view key) {
    const Dimension& wanted = quantity_.measured->dimension;
    if (bound.dimension == wanted || (bound.dimension == kDimensionless && bound.number == 0)) return true;
    const bool is_bare = bound.dimension == kDimensionless;
    error(bound, key,
          in_backticks(word_) + " is " + dimension_name(wanted) + " (e.g. " + dimension_example(wanted) + "), got " +
              (is_bare ? "a number without a unit" : dimension_name(bound.dimension)));
    return false;
  }

  CheckedValue& value_;
  std::string path_;
  Diagnostics& diagnostics_;
  std::string word_;
  ExpectationQuantity quantity_;  // without `measured` where it is wrong or missing
};

}  // namespace

void expectation_pass(CheckedValue& root, Diagnostics& diagnostics) {
  CheckedValue* record = root.find("record");
  CheckedValue* points = record == nullptr ? nullptr : record->find("points");
  if (points != nullptr && root.find("bodies") != nullptr) {
    for (CheckedMember& point : points->members) {
      resolve_name(point.value, "body", choice_of_bodies(root), member_path("record.points", point.key), diagnostics);
    }
  }
  CheckedValue* expectations = root.find("expect");
  if (expectations == nullptr) return;
  const std::optional<double> end = end_of_timeline(clip_times(root));
  for (std::size_t index = 0; index < expectations->items.size(); ++index) {
    ExpectationChecker(expectations->items[index], item_path("expect", index), diagnostics).check(root, end);
  }
}

}  // namespace thinwall
