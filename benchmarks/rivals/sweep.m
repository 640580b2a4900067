% SPDX-License-Identifier: BSD-3-Clause
% q(p) = (K - p^2 A + i p B)^-1 H for many p in GNU Octave: the loop of the paper and the best vectorised forms.
1;

function ways = read(folder)
  A = numbers(folder, "A", 6);
  B = numbers(folder, "B", 6);
  K = numbers(folder, "K", 6);
  H = numbers(folder, "H", 6);
  p = numbers(folder, "p", 1);
  ways.loop = @() loop(A, B, K, H, p);
  ways.ldlt = @() in_pieces(@(some) vectorised_ldlt(A, B, K, H, some), p, 2500);
  ways.modal = @() vectorised_modal(A, B, K, H, p);
endfunction

addpath(fileparts(mfilename("fullpath")));
serve(argv(){end}, @read);
