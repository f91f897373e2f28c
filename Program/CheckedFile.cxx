// SPDX-License-Identifier: BSD-3-Clause
#include "CheckedFile.h"
#include "Messages.h"

#include "vtksys/SystemTools.hxx"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace subdivide
{

bool CheckedFile::Open(const std::string& name)
{
  this->Name = name;
  errno = 0;
  const auto path = std::filesystem::u8path(name);
  return this->open(path, std::ios::out | std::ios::binary | std::ios::trunc) != nullptr;
}

bool CheckedFile::Keep(bool isGood)
{
  if (!isGood && !this->Failed)
  {
    this->Failed = true;
    this->Reason = errno != 0 ? std::strerror(errno) : "unknown reason";
  }
  return !this->Failed;
}

bool CheckedFile::Close()
{
  errno = 0;
  this->Keep(this->close() != nullptr);
  if (this->Failed)
  {
    RemovePart(this->Name);
  }
  return !this->Failed;
}

std::streamsize CheckedFile::xsputn(const char* text, std::streamsize size)
{
  if (!this->Failed)
  {
    this->Keep(std::filebuf::xsputn(text, size) == size);
  }
  return size;
}

CheckedFile::int_type CheckedFile::overflow(int_type letter)
{
  if (!this->Failed)
  {
    this->Keep(!traits_type::eq_int_type(std::filebuf::overflow(letter), traits_type::eof()));
  }
  return traits_type::not_eof(letter);
}

int CheckedFile::sync()
{
  if (!this->Failed)
  {
    this->Keep(std::filebuf::sync() == 0);
  }
  return 0;
}

CheckedFile::pos_type CheckedFile::seekoff(
  off_type offset, std::ios_base::seekdir from, std::ios_base::openmode mode)
{
  const pos_type at = this->Failed ? pos_type(0) : std::filebuf::seekoff(offset, from, mode);
  return this->Keep(at != pos_type(off_type(-1))) ? at : pos_type(0);
}

CheckedFile::pos_type CheckedFile::seekpos(pos_type position, std::ios_base::openmode mode)
{
  const pos_type at = this->Failed ? pos_type(0) : std::filebuf::seekpos(position, mode);
  return this->Keep(at != pos_type(off_type(-1))) ? at : pos_type(0);
}

void RemovePart(const std::string& name)
{
  if (!vtksys::SystemTools::FileIsSymlink(name) && vtksys::SystemTools::FileExists(name, true) &&
    !std::filesystem::is_other(std::filesystem::u8path(name)))
  {
    vtksys::SystemTools::RemoveFile(name);
  }
}

void TellNotWhole(const std::string& name, const std::string& reason)
{
  Tell("error", "\"" + name + "\" cannot be written to its end: " + reason);
}

}
