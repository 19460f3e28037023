#pragma once

#include "../feature/Feature.h"

namespace insonate::review {

class AttemptPage;
class PathPane;
class ResultPage;
class SceneFeature;

/// Result of the open attempt: points and metrics in the center, the needle's path below 3D, and the export of the
/// result to a file.
class ResultFeature final : public Feature {
 public:
  ResultFeature(const ReviewModel& model, AttemptPage& page, SceneFeature& scene);

  /// Shows the points and metrics in the center.
  void showResult();
  /// Asks for a file and saves the result of the open attempt.
  void chooseFile();
  /// Saves the result of the open attempt as a page.
  void saveAs(const QString& file);

 private:
  void showPath();

  AttemptPage& page_;
  SceneFeature& scene_;
  ResultPage* result_;
  PathPane* path_;
};

}  // namespace insonate::review
