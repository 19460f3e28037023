#pragma once

#include <QList>
#include <QSplitter>

class QSettings;

namespace insonate::train {

/// The workspace's three columns: controls, image and patient. The patient's column can temporarily take half of the
/// image's width, and can change places with the controls.
class Columns final : public QSplitter {
 public:
  explicit Columns(QWidget* parent);

  /// Sets the columns; `patient` may be null. All widgets of the columns must already exist, so that Tab goes through
  /// one column after the other.
  void set(QWidget* controls, QWidget* image, QWidget* patient);
  /// Widens the patient's column at the expense of the image, or restores the former width.
  void expandPatient(bool isExpanded);
  /// Puts the controls on the right and the patient on the left, or the reverse.
  void setLeftHanded(bool isLeftHanded);

  /// Saves the columns' widths. If the patient's column is expanded, saves the widths before the expansion.
  void save(QSettings& settings);
  void restore(const QSettings& settings);

 private:
  void setStretch();

  QWidget *controls_ = nullptr, *image_ = nullptr, *patient_ = nullptr;
  bool isExpanded_ = false;
  QList<int> widthsBefore_;  ///< widths before the patient's column was expanded
};

}  // namespace insonate::train
