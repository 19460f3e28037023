#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace insonate::prepare {

class OpenCase;

/// A bar that is shown while the open case is a kept version, for example the published one: a version never changes,
/// so that the author has to open the current case to edit and publish it.
class VersionBanner : public QFrame {
  Q_OBJECT

 public:
  explicit VersionBanner(OpenCase& openCase);

 Q_SIGNALS:
  /// Emitted when the author wants to open the case in this folder, of which the open case is a version.
  void currentCaseRequested(const QString& folder);

 private:
  void refresh();

  OpenCase& openCase_;
  QLabel* text_;
  QPushButton* open_;
};

}  // namespace insonate::prepare
