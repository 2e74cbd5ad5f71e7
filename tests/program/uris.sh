# A report names files as URIs: relative where they are below the current folder, however they were named, else absolute.
small_machine
mkdir in
echo 'G0 X500' | tee a.nc in/b.nc >'c d%.nc'
sed -i 's,mesh=",mesh="../,' m.xml
mv m.xml in/m.xml
cd in
fivecheck -q -f sarif m.xml b.nc ./b.nc "$PWD/b.nc" "${PWD%/in}/a.nc" "../c d%.nc" | tr ',' '\n' | grep -o '"uri": *"[^"]*nc"' |
	sed "s,${PWD%/in},/UP," | uniq
