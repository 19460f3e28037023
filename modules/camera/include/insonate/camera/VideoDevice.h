#pragma once

#include <insonate/camera/CameraSource.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

/// A camera that is plugged in.
struct VideoDeviceInfo {
  std::filesystem::path path;  ///< such as /dev/video0
  std::string name;            ///< name that the camera reports
};

/// Lists the cameras of the system (Video4Linux) that capture images and can be opened.
std::vector<VideoDeviceInfo> listVideoDevices();

/// Opens a camera through Video4Linux, in the format with the least work: 8-bit gray, else YUYV, else MJPEG. The camera
/// chooses the size nearest to `width` x `height` and the frame rate nearest to 30 fps. Fails with a sentence if there
/// is no such device, if another program uses it, if the user may not open it, or if it is no camera.
Result<std::unique_ptr<CameraSource>> openVideoDevice(const std::filesystem::path& path, int width = 1280,
                                                      int height = 720);

}  // namespace insonate
