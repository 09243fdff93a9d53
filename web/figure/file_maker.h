// Has one file of the character made at a time, by work that the platform does elsewhere: it is
// begun once no figure is under way, and while it is made no figure is begun.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "figure/file_options.h"
#include "figure/work_order.h"

namespace marrow {

class FileMaker {
 public:
  static constexpr uint64_t kFirstNumber = uint64_t{1} << 40;  // those of figures begin at 1

  /// The document as a file that will be called `name`; in place of one that is not made yet.
  void ask(const Document& document, const FileOptions& options, const std::string& name);
  /// It is not wanted any more.
  void giveUp();
  /// What was said of the last file is of no interest any more.
  void forgetLast();
  /// Once a frame. occupied: something else is under way, and is waited for.
  std::optional<WorkOrder> update(bool occupied);

  // What the platform tells of the work with this number; of any other than the last it is ignored.
  void made(uint64_t number, const std::string& bytes);
  void progress(uint64_t number, double done);
  /// why: a sentence where the work came to nothing.
  void ended(uint64_t number, const std::string& why);

  struct Ready {
    std::string name, bytes;
  };
  /// The file once it is there.
  std::optional<Ready> take();

  bool waiting() const { return !request_.empty(); }
  /// The platform is at it: what is ordered now would take its place.
  bool working() const { return number_ != 0; }
  bool busy() const { return waiting() || working(); }
  /// 0 … 1.
  double done() const { return done_; }
  const std::string& name() const { return name_; }
  /// Of the last file: a sentence where it came to nothing, and parts that are not in it.
  const std::string& failure() const { return failure_; }
  const std::vector<std::string>& leftOut() const { return left_out_; }

 private:
  std::string request_;  // not begun yet
  std::string name_;
  uint64_t number_ = 0;  // of the work under way; 0: none
  uint64_t last_number_ = kFirstNumber;
  bool given_up_ = false;
  double done_ = 0;
  std::optional<MadeFile> made_;
  std::optional<Ready> ready_;
  std::string failure_;
  std::vector<std::string> left_out_;
};

}  // namespace marrow
