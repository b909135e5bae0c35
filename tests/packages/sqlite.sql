-- SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
CREATE TABLE mesh(id INTEGER PRIMARY KEY, region TEXT, weight REAL);
WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 60000)
  INSERT INTO mesh SELECT i, 'r' || (i * 7919 % 97), 1.0 / (1 + i * 104729 % 1009) FROM n;
CREATE INDEX by_region ON mesh(region, weight);
SELECT region, count(*), sum(weight), min(id), max(id) FROM mesh GROUP BY region ORDER BY 3 DESC, 1 LIMIT 10;
SELECT a.region, count(*) FROM mesh a JOIN mesh b ON b.id = a.id * 2 AND b.weight > a.weight
  GROUP BY 1 ORDER BY 2 DESC, 1 LIMIT 5;
SELECT id, sum(weight) OVER (ORDER BY id ROWS 3 PRECEDING), rank() OVER (ORDER BY weight, id)
  FROM mesh WHERE id % 10000 = 1 ORDER BY id;
BEGIN;
UPDATE mesh SET weight = weight * 2 WHERE region LIKE 'r1%';
DELETE FROM mesh WHERE id % 3 = 0;
SELECT count(*), total(weight) FROM mesh;
ROLLBACK;
SELECT count(*), total(weight), group_concat(DISTINCT substr(region, 2, 1)) FROM mesh;
SELECT json_extract('{"a":[1,2,{"b":3}]}', '$.a[2].b'), printf('%.17g', 1.0 / 3), hex(zeroblob(3)), quote(x'00ff');
SELECT value, length(value) FROM json_each('["x","yy","zzz"]');
PRAGMA integrity_check;
