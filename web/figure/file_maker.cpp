#include "figure/file_maker.h"

#include <utility>

#include "figure/workshop.h"

namespace marrow {

void FileMaker::ask(const Document& document, const FileOptions& options, const std::string& name) {
  giveUp();
  request_ = fileRequest(document, options);
  name_ = name;
  done_ = 0;
  failure_.clear();
  left_out_.clear();
}

void FileMaker::giveUp() {
  request_.clear();
  given_up_ = number_ != 0;
}

void FileMaker::forgetLast() {
  failure_.clear();
  left_out_.clear();
}

std::optional<WorkOrder> FileMaker::update(bool occupied) {
  if (given_up_) {
    given_up_ = false;
    number_ = 0;
    return WorkOrder{};
  }
  if (request_.empty() || occupied || number_ != 0) return std::nullopt;
  made_.reset();
  number_ = ++last_number_;
  return WorkOrder{number_, std::exchange(request_, {})};
}

void FileMaker::made(uint64_t number, const std::string& bytes) {
  if (number != number_ || number == 0 || given_up_) return;
  auto file = fileFromBytes(bytes);
  if (file) {
    made_ = std::move(*file);
  } else {
    failure_ = file.message();
  }
}

void FileMaker::progress(uint64_t number, double done) {
  if (number == number_) done_ = done;
}

void FileMaker::ended(uint64_t number, const std::string& why) {
  if (number != number_ || number == 0 || given_up_) return;
  number_ = 0;
  if (!why.empty()) failure_ = why;
  if (!failure_.empty() || !made_) return;
  left_out_ = std::move(made_->left_out);
  ready_ = Ready{name_, std::move(made_->bytes)};
  made_.reset();
}

std::optional<FileMaker::Ready> FileMaker::take() { return std::exchange(ready_, std::nullopt); }

}  // namespace marrow
