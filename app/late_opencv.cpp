// Linked into programs, `striate` and tests, not into libraries; see late_opencv.hpp. The names are
// those of the Itanium C++ ABI, under which a member function is a function that takes the object
// first.
#include "striate/app/late_opencv.hpp"

#include <dlfcn.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <opencv2/ximgproc/disparity_filter.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

void* library(const char* file) {
  void* const handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw std::runtime_error(
        std::string(dlerror()) + "; install " + file +
        " (Debian: libopencv-imgcodecs406, libopencv-videoio406, libopencv-contrib406)");
  }
  return handle;  // never closed: what it made may still be in use
}

void* codecs() {
  static void* const handle = library(STRIATE_IMGCODECS_LIBRARY);
  return handle;
}

void* videos() {
  static void* const handle = library(STRIATE_VIDEOIO_LIBRARY);
  return handle;
}

void* filters() {
  static void* const handle = library(STRIATE_XIMGPROC_LIBRARY);
  return handle;
}

/// A function of OpenCV by its mangled name.
template <class Function>
Function* late(void* from, const char* name) {
  void* const found = dlsym(from, name);
  if (found == nullptr) throw std::runtime_error(dlerror());
  return reinterpret_cast<Function*>(found);
}

}  // namespace

// The program's own, called where the library has a weak reference (run_mission.cpp).
extern "C" void striate_load_opencv_codecs() {
  codecs();
}

namespace cv {

using Params = std::vector<int>;

Mat imread(const String& file, int flags) {
  static auto* const real = late<Mat(const String&, int)>(
      codecs(), "_ZN2cv6imreadERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEi");
  return real(file, flags);
}

bool imwrite(const String& file, InputArray image, const Params& params) {
  static auto* const real = late<bool(const String&, InputArray, const Params&)>(
      codecs(),
      "_ZN2cv7imwriteERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_11_InputArrayERK"
      "St6vectorIiSaIiEE");
  return real(file, image, params);
}

Mat imdecode(InputArray bytes, int flags) {
  static auto* const real =
      late<Mat(InputArray, int)>(codecs(), "_ZN2cv8imdecodeERKNS_11_InputArrayEi");
  return real(bytes, flags);
}

bool imencode(const String& suffix, InputArray image, std::vector<uchar>& bytes,
              const Params& params) {
  static auto* const real = late<bool(const String&, InputArray, std::vector<uchar>&,
                                      const Params&)>(
      codecs(),
      "_ZN2cv8imencodeERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_11_InputArrayE"
      "RSt6vectorIhSaIhEERKSB_IiSaIiEE");
  return real(suffix, image, bytes, params);
}

bool haveImageReader(const String& file) {
  static auto* const real = late<bool(const String&)>(
      codecs(), "_ZN2cv15haveImageReaderERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE");
  return real(file);
}

bool haveImageWriter(const String& file) {
  static auto* const real = late<bool(const String&)>(
      codecs(), "_ZN2cv15haveImageWriterERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE");
  return real(file);
}

// The compiler makes a table of virtual functions here, which names them all.

VideoCapture::VideoCapture() : throwOnFail(false) {
  static auto* const real = late<void(VideoCapture*)>(videos(), "_ZN2cv12VideoCaptureC1Ev");
  real(this);  // its members hold nothing yet that could be lost
}

VideoCapture::~VideoCapture() {
  release();
}

bool VideoCapture::open(const String& file, int api) {
  static auto* const real = late<bool(VideoCapture*, const String&, int)>(
      videos(),
      "_ZN2cv12VideoCapture4openERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEi");
  return real(this, file, api);
}

bool VideoCapture::open(const String& file, int api, const Params& params) {
  static auto* const real = late<bool(VideoCapture*, const String&, int, const Params&)>(
      videos(),
      "_ZN2cv12VideoCapture4openERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiRKSt6vector"
      "IiSaIiEE");
  return real(this, file, api, params);
}

bool VideoCapture::open(int index, int api) {
  static auto* const real =
      late<bool(VideoCapture*, int, int)>(videos(), "_ZN2cv12VideoCapture4openEii");
  return real(this, index, api);
}

bool VideoCapture::open(int index, int api, const Params& params) {
  static auto* const real = late<bool(VideoCapture*, int, int, const Params&)>(
      videos(), "_ZN2cv12VideoCapture4openEiiRKSt6vectorIiSaIiEE");
  return real(this, index, api, params);
}

bool VideoCapture::isOpened() const {
  static auto* const real =
      late<bool(const VideoCapture*)>(videos(), "_ZNK2cv12VideoCapture8isOpenedEv");
  return real(this);
}

void VideoCapture::release() {
  static auto* const real = late<void(VideoCapture*)>(videos(), "_ZN2cv12VideoCapture7releaseEv");
  real(this);
}

bool VideoCapture::grab() {
  static auto* const real = late<bool(VideoCapture*)>(videos(), "_ZN2cv12VideoCapture4grabEv");
  return real(this);
}

bool VideoCapture::retrieve(OutputArray image, int flag) {
  static auto* const real = late<bool(VideoCapture*, OutputArray, int)>(
      videos(), "_ZN2cv12VideoCapture8retrieveERKNS_12_OutputArrayEi");
  return real(this, image, flag);
}

bool VideoCapture::read(OutputArray image) {
  static auto* const real = late<bool(VideoCapture*, OutputArray)>(
      videos(), "_ZN2cv12VideoCapture4readERKNS_12_OutputArrayE");
  return real(this, image);
}

VideoCapture& VideoCapture::operator>>(Mat& image) {
  read(image);
  return *this;
}

VideoCapture& VideoCapture::operator>>(UMat& image) {
  read(image);
  return *this;
}

bool VideoCapture::set(int property, double value) {
  static auto* const real =
      late<bool(VideoCapture*, int, double)>(videos(), "_ZN2cv12VideoCapture3setEid");
  return real(this, property, value);
}

double VideoCapture::get(int property) const {
  static auto* const real =
      late<double(const VideoCapture*, int)>(videos(), "_ZNK2cv12VideoCapture3getEi");
  return real(this, property);
}

namespace ximgproc {

Ptr<DisparityWLSFilter> createDisparityWLSFilter(Ptr<StereoMatcher> left) {
  static auto* const real = late<Ptr<DisparityWLSFilter>(Ptr<StereoMatcher>)>(
      filters(), "_ZN2cv8ximgproc24createDisparityWLSFilterENS_3PtrINS_13StereoMatcherEEE");
  return real(std::move(left));
}

Ptr<StereoMatcher> createRightMatcher(Ptr<StereoMatcher> left) {
  static auto* const real = late<Ptr<StereoMatcher>(Ptr<StereoMatcher>)>(
      filters(), "_ZN2cv8ximgproc18createRightMatcherENS_3PtrINS_13StereoMatcherEEE");
  return real(std::move(left));
}

}  // namespace ximgproc

}  // namespace cv
