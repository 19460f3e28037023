#pragma once

#include <QList>
#include <QSplitter>

class QSettings;

namespace insonate::train {

/// The three columns of the workspace: controls, image and patient. The patient's column can take half of the image's
/// width for a while, and change places with the controls.
class Columns final : public QSplitter {
 public:
  explicit Columns(QWidget* parent);

  /// Sets the columns, of which the patient's may be null. Each comes with all its widgets, so that Tab goes through
  /// one after the other.
  void set(QWidget* controls, QWidget* image, QWidget* patient);
  /// Widens the patient's column at the image's expense, or restores it.
  void expandPatient(bool isExpanded);
  /// Controls on the right, patient on the left.
  void setLeftHanded(bool isLeftHanded);

  /// Saves the widths, those of the patient's column as it is when not expanded.
  void save(QSettings& settings);
  void restore(const QSettings& settings);

 private:
  void setStretch();

  QWidget *controls_ = nullptr, *image_ = nullptr, *patient_ = nullptr;
  bool isExpanded_ = false;
  QList<int> widthsBefore_;  ///< before the patient's column was expanded
};

}  // namespace insonate::train
