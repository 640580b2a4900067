% SPDX-License-Identifier: BSD-3-Clause
% q(p) = (K - p^2 A + i p B)^-1 H: the loop of the paper.
function q = loop(A, B, K, H, p)
  q = zeros(6, numel(p));
  for k = 1:numel(p)
    q(:, k) = (K - p(k)^2 * A + 1i * p(k) * B) \ H;
  endfor
endfunction
