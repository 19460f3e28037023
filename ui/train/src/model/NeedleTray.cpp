#include "NeedleTray.h"

namespace insonate::train {

void NeedleTray::set(bool isOut, NeedlePlace needle) {
  if (isOut_ == isOut && needle_ == needle) return;
  isOut_ = isOut, needle_ = needle;
  Q_EMIT changed();
}

}  // namespace insonate::train
