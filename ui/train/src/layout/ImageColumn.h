#pragma once

#include <QWidget>
#include <array>

class QVBoxLayout;

namespace insonate::train {

/// The middle column: the image, and slots under it.
class ImageColumn final : public QWidget {
 public:
  /// Slots from top to bottom. Image takes the height that the other slots leave.
  enum Slot { Image, Note, Curve, Line, Bar };

  explicit ImageColumn(QWidget* parent = nullptr);

  /// Adds a widget at the bottom of its slot.
  void add(Slot slot, QWidget* widget);

 private:
  std::array<QVBoxLayout*, Bar + 1> slots_{};
};

}  // namespace insonate::train
