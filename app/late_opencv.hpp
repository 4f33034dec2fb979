#pragma once

/// OpenCV's readers and writers of images and videos bring more than two hundred libraries along
/// (GDAL, FFmpeg, GStreamer), and loading those takes half a second of the processor's time. So the
/// program `striate` and the tests load them when they are first needed: late_opencv.cpp defines
/// the functions of OpenCV that Striate calls, and the linker then leaves the libraries out.
namespace striate::app {

/// Loads them now, so that no cycle of a real robot waits for it. Does nothing in programs that are
/// linked with them. @throws std::runtime_error where a library cannot be loaded
void load_opencv_codecs();

}  // namespace striate::app
