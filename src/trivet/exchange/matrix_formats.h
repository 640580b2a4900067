// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {

/// Reads a square matrix of real numbers, one row per line, with commas, semicolons, tabs or blanks between the
/// numbers. Lines that start with # and blank lines are skipped; a first line of words is a heading. No labels.
[[nodiscard]] foundation::Expected<NamedMatrix> read_csv_matrix(std::string_view text, const std::string& source);

/// Reads a Matrix Market text: coordinate or array, real, integer or complex, general, symmetric,
/// skew-symmetric or hermitian; exponents of C or Fortran. No labels.
/// [Boisvert, Pozo, Remington, The Matrix Market Exchange Formats, NISTIR 5935, 1996]
[[nodiscard]] foundation::Expected<NamedMatrix> read_matrix_market(std::string_view text, const std::string& source);

/// Reads the bytes of a NumPy `.npy` file, format 1.0, 2.0 or 3.0: a square matrix of float64 or complex128,
/// little-endian, in C or Fortran order. No labels. [NumPy, numpy.lib.format]
[[nodiscard]] foundation::Expected<NamedMatrix> read_numpy_array(std::string_view bytes, const std::string& source);

/// Reads a linear user element in Abaqus keywords: *USER ELEMENT, its nodes in a comment, its components, and the
/// *MATRIX of this type (lower case): the lower triangle row by row, or all rows if it is unsymmetric.
[[nodiscard]] foundation::Expected<NamedMatrix> read_user_element(std::string_view text, const std::string& type,
                                                                  FileProblems& problems);

/// Reads a matrix text (.mtx) of Abaqus or CalculiX:
/// – substructure matrix output: *USER ELEMENT with its nodes and components, then *MATRIX, TYPE=STIFFNESS;
/// – Abaqus matrix output in the form MATRIX INPUT: row node, row component, column node, column component, value.
/// @param type  of the requested *MATRIX: "stiffness", "mass", …
/// [Abaqus Keywords Guide, *MATRIX, *MATRIX OUTPUT; CalculiX User's Manual, *SUBSTRUCTURE MATRIX OUTPUT]
[[nodiscard]] foundation::Expected<NamedMatrix> read_abaqus_matrix(std::string_view text, const std::string& source,
                                                                   const std::string& type = "stiffness");

/// One field of a bulk data card, and its line number.
struct Field {
  std::string_view text;
  int line = 0;
};

/// A card of Nastran bulk data with its continuations: all data fields in one list, eight per line in small and free
/// field format, four per line in large field format.
struct Card {
  int line = 0;
  std::vector<Field> fields;
};

/// Text with tabs replaced by blanks up to the next multiple of eight columns.
[[nodiscard]] std::string without_tabs(std::string_view text);

/// All cards of this name (lower case) up to ENDDATA; other lines are skipped. The views point into `text`.
[[nodiscard]] std::vector<Card> bulk_cards(std::string_view text, std::string_view name);

/// Reads a matrix of Nastran DMIG cards from bulk data or a punch file: small, large and free field; real and complex,
/// also polar; square (IFO 1) and symmetric (6). Rows are sorted by grid point and component; a scalar point has
/// component 0.
/// @param name  of the matrix, "KAAX" for instance; may be empty if the file has only one
/// [MSC Nastran Quick Reference Guide, DMIG]
[[nodiscard]] foundation::Expected<NamedMatrix> read_nastran_dmig(std::string_view text, const std::string& source,
                                                                  const std::string& name = "");

}  // namespace trivet::exchange
