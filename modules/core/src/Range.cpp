#include <insonate/core/Range.h>

#include <sstream>

namespace insonate {

Result<void> checkRange(double value, double low, double high, const std::string& what) {
  if (value >= low && value <= high) return {};
  std::ostringstream text;
  text << what << " is " << value << "; allowed is " << low << " to " << high << ".";
  return fail(text.str());
}

}  // namespace insonate
