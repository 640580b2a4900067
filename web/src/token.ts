// SPDX-License-Identifier: BSD-3-Clause
// The token of this tab, and how a tab whose program was started again gets the new one (docs/serve.md): it has a key
// that no request carries, so that another program at the same port learns nothing from it.

/// Once in the fragment of the address, then only in the storage of the tab.
export function tokenOfTab(): string {
  const inAddress = new URLSearchParams(location.hash.slice(1)).get('token');
  if (inAddress) {
    sessionStorage.setItem('token', inAddress);
    history.replaceState(null, '', location.pathname);
  }
  return sessionStorage.getItem('token') ?? '';
}
export const keepToken = (token: string) => sessionStorage.setItem('token', token);

/// What the program answers to a nonce.
export interface SealedToken {
  nonce: string;
  sealed: string;
  proof: string;
}
export const newNonce = () => hexadecimal(crypto.getRandomValues(new Uint8Array(32)));

/// The token in an answer; null if its sender does not have the key.
export async function openedToken({nonce, sealed, proof}: SealedToken, key: string, port: string, ourNonce: string): Promise<string | null> {
  const keyed = async (words: string) => sha256(key + await sha256(key + words)), words = `${port} ${ourNonce} ${nonce}`;
  const mask = await keyed(`token ${words}`);
  const token = [...sealed].map((digit, i) => (parseInt(digit, 16) ^ parseInt(mask[i]!, 16)).toString(16)).join('');
  return proof === await keyed(`proof ${words} ${token}`) ? token : null;
}
const sha256 = async (text: string) => hexadecimal(new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text))));
const hexadecimal = (bytes: Uint8Array) => [...bytes].map(byte => byte.toString(16).padStart(2, '0')).join('');
