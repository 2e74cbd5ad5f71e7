/*
 * main.c - fivecheck-mesh FILE: prints the meshes of a file that libassimp can read, for `fivecheck import`.
 *
 * This is a separate program, so that a reader of a dozen formats is not part of the checker, and so that the import
 * can limit the memory and the time that a broken file takes. It opens the file and, for glTF, its buffers beside it;
 * nothing else.
 *
 * Output: for each mesh of each node a line "mesh COUNT NAME" and COUNT triangles of nine 32-bit floats, little-endian,
 * in the units of the file, with the placement of the node; at the end the line "end", or "fault" and the reason.
 */
#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* More nodes than a model of a machine has; nesting is limited, too. */
enum { NODES_MAX = 100000, DEPTH_MAX = 100 };
#define TRIANGLES_MAX 50000000ULL

/* ------------------------------------------------------------------- files */

static size_t file_read(struct aiFile *file, char *bytes, size_t size, size_t count)
{
	return fread(bytes, size, count, (FILE *)file->UserData);
}

static size_t file_write(struct aiFile *file, const char *bytes, size_t size, size_t count)
{
	(void)file;
	(void)bytes;
	(void)size;
	(void)count;
	return 0;
}

static size_t file_tell(struct aiFile *file)
{
	return (size_t)ftell((FILE *)file->UserData);
}

static size_t file_size(struct aiFile *file)
{
	FILE *stream = (FILE *)file->UserData;
	long here = ftell(stream), size;

	fseek(stream, 0, SEEK_END);
	size = ftell(stream);
	fseek(stream, here, SEEK_SET);
	return (size_t)size;
}

static enum aiReturn file_seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
	const int whence = origin == aiOrigin_SET ? SEEK_SET : origin == aiOrigin_CUR ? SEEK_CUR : SEEK_END;

	return fseek((FILE *)file->UserData, (long)offset, whence) ? aiReturn_FAILURE : aiReturn_SUCCESS;
}

static void file_flush(struct aiFile *file)
{
	(void)file;
}

/* The folder of a path, with its last slash. */
static size_t folder_length(const char *path)
{
	const char *slash = strrchr(path, '/');

	return slash ? (size_t)(slash - path) + 1 : 0;
}

/* Is it the file itself, or one beside it? */
static bool may_open(const char *main_file, const char *path)
{
	size_t folder = folder_length(main_file);
	const char *name = path;

	if (!strncmp(path, "./", 2) && !folder)
		name += 2;
	else if (!strncmp(path, main_file, folder))
		name += folder;
	else
		return false;
	return *name && !strchr(name, '/') && !strchr(name, '\\') && strcmp(name, "..") != 0;
}

static struct aiFile *open_file(struct aiFileIO *io, const char *path, const char *mode)
{
	struct aiFile *file;
	FILE *stream;

	if (*mode != 'r' || !may_open((const char *)io->UserData, path))
		return NULL;
	stream = fopen(path, "rb");
	if (!stream)
		return NULL;
	file = calloc(1, sizeof(*file));
	if (!file) {
		fclose(stream);
		return NULL;
	}
	*file = (struct aiFile){file_read, file_write, file_tell, file_size, file_seek, file_flush, (char *)stream};
	/* cppcheck-suppress resourceLeak ; close_file closes the stream */
	return file;
}

static void close_file(struct aiFileIO *io, struct aiFile *file)
{
	(void)io;
	fclose((FILE *)file->UserData);
	free(file);
}

/* ----------------------------------------------------------------- output */

struct printing {
	const struct aiScene *scene;
	size_t nodes;
	unsigned long long triangles;
	const char *fault;
};

static size_t count_triangles(const struct aiMesh *mesh)
{
	size_t count = 0;

	for (unsigned i = 0; i < mesh->mNumFaces; i++)
		count += mesh->mFaces[i].mNumIndices == 3;
	return count;
}

static void put_float(double value)
{
	const float rounded = (float)value;
	unsigned char bytes[4];
	uint32_t bits;

	memcpy(&bits, &rounded, sizeof(bits));
	for (int i = 0; i < 4; i++)
		bytes[i] = (unsigned char)(bits >> (8 * i));
	fwrite(bytes, 1, sizeof(bytes), stdout);
}

static void put_corner(const struct aiMatrix4x4 *m, const struct aiVector3D *p)
{
	put_float((double)m->a1 * p->x + (double)m->a2 * p->y + (double)m->a3 * p->z + m->a4);
	put_float((double)m->b1 * p->x + (double)m->b2 * p->y + (double)m->b3 * p->z + m->b4);
	put_float((double)m->c1 * p->x + (double)m->c2 * p->y + (double)m->c3 * p->z + m->c4);
}

static void put_name(const char *name)
{
	for (; *name; name++)
		putchar((unsigned char)*name < 0x20 ? '_' : *name);
}

/* A mirrored node turns its triangles inside out; reversing the order of their corners corrects this. */
static bool is_mirrored(const struct aiMatrix4x4 *m)
{
	return (double)m->a1 * ((double)m->b2 * m->c3 - (double)m->b3 * m->c2) -
		       (double)m->a2 * ((double)m->b1 * m->c3 - (double)m->b3 * m->c1) +
		       (double)m->a3 * ((double)m->b1 * m->c2 - (double)m->b2 * m->c1) <
	       0;
}

static void put_mesh(struct printing *p, const struct aiMesh *mesh, const struct aiMatrix4x4 *pose, const char *name)
{
	const bool mirrored = is_mirrored(pose);
	size_t count = count_triangles(mesh);

	p->triangles += count;
	if (p->triangles > TRIANGLES_MAX)
		p->fault = "more than 50 million triangles";
	if (!count || p->fault)
		return;
	printf("mesh %zu ", count);
	put_name(name && *name ? name : mesh->mName.data);
	putchar('\n');
	for (unsigned i = 0; i < mesh->mNumFaces && !p->fault; i++) {
		const struct aiFace *face = &mesh->mFaces[i];

		for (int k = 0; k < 3 && face->mNumIndices == 3; k++) {
			unsigned index = face->mIndices[mirrored ? 2 - k : k];

			if (index >= mesh->mNumVertices)
				p->fault = "a triangle refers to a corner that does not exist";
			else
				put_corner(pose, &mesh->mVertices[index]);
		}
	}
}

/* Nesting is limited. NOLINTNEXTLINE(misc-no-recursion) */
static void put_node(struct printing *p, const struct aiNode *node, struct aiMatrix4x4 pose, int depth)
{
	if (depth > DEPTH_MAX || ++p->nodes > NODES_MAX)
		p->fault = "too many nodes, or nodes nested too deep";
	aiMultiplyMatrix4(&pose, &node->mTransformation);
	for (unsigned i = 0; i < node->mNumMeshes && !p->fault; i++)
		if (node->mMeshes[i] < p->scene->mNumMeshes)
			put_mesh(p, p->scene->mMeshes[node->mMeshes[i]], &pose, node->mName.data);
	for (unsigned i = 0; i < node->mNumChildren && !p->fault; i++)
		put_node(p, node->mChildren[i], pose, depth + 1);
}

static int complain(const char *what)
{
	printf("fault ");
	put_name(what);
	putchar('\n');
	return 2;
}

int main(int argc, char **argv)
{
	struct aiFileIO io = {open_file, close_file, argc > 1 ? argv[1] : NULL};
	struct printing printing = {0};
	struct aiMatrix4x4 pose;

	if (argc != 2)
		return complain("give one file; fivecheck import calls this program");
	printing.scene = aiImportFileEx(argv[1], aiProcess_Triangulate | aiProcess_ValidateDataStructure, &io);
	if (!printing.scene)
		return complain(aiGetErrorString());
	if (printing.scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE || !printing.scene->mRootNode)
		return complain("the file is not complete");
	aiIdentityMatrix4(&pose);
	put_node(&printing, printing.scene->mRootNode, pose, 0);
	aiReleaseImport(printing.scene);
	if (printing.fault)
		return complain(printing.fault);
	printf("end\n");
	return fflush(stdout) == 0 ? 0 : 2;
}
