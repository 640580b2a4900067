% SPDX-License-Identifier: BSD-3-Clause
% In pieces that stay in the cache.
function q = in_pieces(evaluate, p, piece)
  q = zeros(6, numel(p));
  for first = 1:piece:numel(p)
    some = first:min(first + piece - 1, numel(p));
    q(:, some) = evaluate(p(some));
  endfor
endfunction
