-- SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
-- Lua's language and libraries, every result printed; an argument repeats the work that many times.
local state = 12345
local function random(n)
  state = (state * 1103515245 + 12345) % 2147483648
  return state // 65536 % n + 1
end

local function numbers()
  local t = {}
  for i = 1, 20000 do t[i] = random(1000000) end
  table.sort(t)
  local sum, histogram = 0, {}
  for i, v in ipairs(t) do
    sum = sum + v / i
    histogram[v % 64] = (histogram[v % 64] or 0) + 1
  end
  local counts = {}
  for i = 0, 63 do counts[#counts + 1] = histogram[i] end
  return string.format("%a %s", sum, table.concat(counts, " "))
end

local function strings()
  local parts = {}
  for i = 1, 3000 do parts[i] = string.format("%05d-%s-%q", random(99999), ("x"):rep(random(9)), "a\nb") end
  local text = table.concat(parts, ",")
  local digits = select(2, text:gsub("%d", ""))
  local packed = string.pack("<i4dz", 7, 1 / 3, "end")
  return #text, digits, text:find("x-\"", 1, true), string.unpack("<i4dz", packed), utf8.len("äöü€"),
    text:upper():reverse():sub(1, 20), ("%g"):format(2 ^ 0.5)
end

local function coroutines()
  local function primes(n)
    return coroutine.wrap(function()
      for i = 2, n do
        local prime = true
        for d = 2, math.floor(math.sqrt(i)) do if i % d == 0 then prime = false break end end
        if prime then coroutine.yield(i) end
      end
    end)
  end
  local sum = 0
  for p in primes(5000) do sum = sum + p end
  return sum
end

local function objects()
  local Account = {}
  Account.__index = Account
  Account.__add = function(a, b) return setmetatable({ value = a.value + b.value }, Account) end
  Account.__close = function(a) state = state + a.value end
  local total = setmetatable({ value = 0 }, Account)
  for i = 1, 2000 do
    local one <close> = setmetatable({ value = i }, Account)
    total = total + one
  end
  local weak = setmetatable({}, { __mode = "k" })
  for _ = 1, 1000 do weak[{}] = true end
  collectgarbage()
  return total.value, next(weak), state
end

local function errors()
  local ok, message = pcall(function() local x = nil; return x.y end)
  local loaded = assert(load("local a <const> = 6; return a * 7"))()
  local _, syntax = load("for i = 1 do end")
  return ok, message:match(":%s*(.*)"), loaded, syntax, (select(2, pcall(error, { 1 })))[1], 7 // 2, -7 // 2,
    -7 % 3, 1 << 62, math.maxinteger + 1 == math.mininteger, 3 | 4 ~ 1
end

for _ = 1, tonumber(arg[1]) or 1 do
  for _, part in ipairs { numbers, strings, coroutines, objects, errors } do print(part()) end
end
