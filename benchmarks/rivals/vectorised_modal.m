% SPDX-License-Identifier: BSD-3-Clause
% The same by poles and residues of the 12 states, all frequencies at once.
function q = vectorised_modal(A, B, K, H, p)
  [R, lambda] = poles(A, B, K, H);
  q = R * (1 ./ (1i * p - lambda));
endfunction
