// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckedFile.h
 * Files that are whole, or reported: some of VTK's writers crash when a disk is full, others do not
 * notice.
 */
#ifndef SubdivisionObjects_CheckedFile_h
#define SubdivisionObjects_CheckedFile_h

#include <fstream>
#include <string>

namespace subdivide
{

/// A file to be written that takes everything, and remembers whether all could be stored.
class CheckedFile : public std::filebuf
{
public:
  /// Empties the file, or makes it. Returns whether it can be written.
  bool Open(const std::string& name);

  /// Returns whether everything was stored. If not, the file is removed.
  bool Close();

  /// Why not: the words of the system.
  const std::string& GetReason() const { return this->Reason; }

protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int_type overflow(int_type letter) override;
  int sync() override;
  pos_type seekoff(off_type, std::ios_base::seekdir, std::ios_base::openmode) override;
  pos_type seekpos(pos_type, std::ios_base::openmode) override;

private:
  bool Keep(bool isGood);

  std::string Name;
  std::string Reason;
  bool Failed = false;
};

/// Removes what was written of a file that is not whole; devices and links stay.
void RemovePart(const std::string& name);

/// Tells that the file is not whole, and why.
void TellNotWhole(const std::string& name, const std::string& reason);

}

#endif
